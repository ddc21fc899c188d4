#include "block_projection.hpp"

#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// Where in a block the surface lies, in voxel edges: 3 bits of the place, 5 of the surface.
inline float edges(std::uint32_t place_bits, std::uint32_t surface_bits) {
  return (static_cast<float>(static_cast<int>((place_bits & 7) << 5 | (surface_bits & 31))) + 0.5F) / 32.0F;
}

STILLMAP_VECTOR_CLONES void place_in_sensor_frame(std::size_t n, const std::uint32_t* __restrict packed,
                                                  const Eigen::Vector3f& corner, const Eigen::Matrix3f& step,
                                                  float* __restrict x, float* __restrict y,
                                                  float* __restrict z) {
  const float xx = step(0, 0), xy = step(0, 1), xz = step(0, 2), x0 = corner.x();
  const float yx = step(1, 0), yy = step(1, 1), yz = step(1, 2), y0 = corner.y();
  const float zx = step(2, 0), zy = step(2, 1), zz = step(2, 2), z0 = corner.z();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = packed[i] >> 15, surface = packed[i] & 0x7FFF;
    const float u = edges(place, surface);
    const float v = edges(place >> kBlockShift, surface >> 5);
    const float w = edges(place >> (2 * kBlockShift), surface >> 10);
    x[i] = x0 + xx * u + xy * v + xz * w;
    y[i] = y0 + yx * u + yy * v + yz * w;
    z[i] = z0 + zx * u + zy * v + zz * w;
  }
}

}  // namespace

void BlockProjection::project(const Eigen::Vector3f& corner_sensor_m, const ScanView& view, float voxel_m) {
  place_in_sensor_frame(size_, packed_, corner_sensor_m, view.R_sensor_map * voxel_m, x_, y_, z_);
  spherical(size_, x_, y_, z_, azimuth_rad_, elevation_rad_, range_m_);
}

}  // namespace stillmap
