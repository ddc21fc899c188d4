#include "located_rows.hpp"

#include <algorithm>
#include <cmath>

#include "for_rows.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// One axis of the map: which voxel, and how far from its low corner, in voxel edges.
struct Axis {
  double rx, ry, rz, t;  ///< from the sensor frame to voxel edges
};

/// Voxel and offset along one axis of rows first .. last - 1.
STILLMAP_VECTOR_CLONES void locate_along(const Axis axis, std::size_t n, const float* __restrict x,
                                         const float* __restrict y, const float* __restrict z,
                                         int* __restrict key, float* __restrict offset) {
  constexpr double kLimit = kVoxelKeyLimit;  // what lies beyond is told by its key
  for (std::size_t i = 0; i < n; ++i) {
    const double edges = axis.rx * x[i] + axis.ry * y[i] + axis.rz * z[i] + axis.t;
    const double corner = std::min(std::max(-kLimit, std::floor(edges)), kLimit);  // NaN: -kLimit
    key[i] = static_cast<int>(corner);
    offset[i] = static_cast<float>(edges - corner);
  }
}

STILLMAP_VECTOR_CLONES void pack_keys(std::size_t n, const float* __restrict range_m, const int* __restrict x,
                                      const int* __restrict y, const int* __restrict z,
                                      std::uint64_t* __restrict block, std::uint16_t* __restrict place) {
  constexpr int kLimit = kVoxelKeyLimit;
  for (std::size_t i = 0; i < n; ++i) {
    const bool inside =
        (range_m[i] > 0) & (std::abs(x[i]) < kLimit) & (std::abs(y[i]) < kLimit) & (std::abs(z[i]) < kLimit);
    const VoxelKey key(x[i], y[i], z[i]);
    block[i] = inside ? packed(block_key(key)) : LocatedRows::kNowhere;
    place[i] = static_cast<std::uint16_t>(place_in_block(key));
  }
}

}  // namespace

void LocatedRows::locate(const ProjectedScan& scan, const Eigen::Isometry3d& T_map_sensor,
                         double inverse_voxel_size) {
  const Eigen::Matrix3d R = T_map_sensor.linear() * inverse_voxel_size;
  const Eigen::Vector3d t = T_map_sensor.translation() * inverse_voxel_size;
  block.resize(scan.size());
  place.resize(scan.size());
  for (std::vector<float>* axis : {&x, &y, &z}) axis->resize(scan.size());
  for_rows(scan.size(), [&](std::size_t first, std::size_t last) {
    constexpr std::size_t kAtOnce = 512;
    int key[3][kAtOnce];
    for (; first < last; first += kAtOnce) {
      const std::size_t n = std::min(kAtOnce, last - first);
      float* offset[] = {&x[first], &y[first], &z[first]};
      for (int a = 0; a < 3; ++a)
        locate_along({R(a, 0), R(a, 1), R(a, 2), t[a]}, n, &scan.x_m[first], &scan.y_m[first],
                     &scan.z_m[first], key[a], offset[a]);
      pack_keys(n, &scan.range_m[first], key[0], key[1], key[2], &block[first], &place[first]);
    }
  });
}

}  // namespace stillmap
