// What another package does with the installed library.
#include <stillmap/mapper.hpp>

int main() {
  stillmap::Mapper mapper{stillmap::Parameters{}};
  stillmap::Scan wall;
  for (int i = -50; i <= 50; ++i) wall.points.emplace_back(5.f, 0.05f * float(i), 0.f);
  for (int k = 0; k < 5; ++k) mapper.process(wall, Eigen::Isometry3d::Identity());
  return mapper.voxel_count() > 10 && mapper.scan_count() == 5 ? 0 : 1;
}
