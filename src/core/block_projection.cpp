#include "block_projection.hpp"

#include <algorithm>

#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// Where in a block the surface lies, in voxel edges: 3 bits of the place, 5 of the surface.
inline float edges(std::uint32_t place_bits, std::uint32_t surface_bits) {
  return (static_cast<float>(static_cast<int>((place_bits & 7) << 5 | (surface_bits & 31))) + 0.5F) / 32.0F;
}

/// Where the voxels' surfaces are seen. Also spherical(), in the same loop.
STILLMAP_VECTOR_CLONES void see(std::size_t n, const std::uint32_t* __restrict packed,
                                const Eigen::Vector3f& corner, const Eigen::Matrix3f& step,
                                float* __restrict azimuth_rad, float* __restrict elevation_rad,
                                float* __restrict range_m) {
  const float xx = step(0, 0), xy = step(0, 1), xz = step(0, 2), x0 = corner.x();
  const float yx = step(1, 0), yy = step(1, 1), yz = step(1, 2), y0 = corner.y();
  const float zx = step(2, 0), zy = step(2, 1), zz = step(2, 2), z0 = corner.z();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = packed[i] >> 15, surface = packed[i] & 0x7FFF;
    const float u = edges(place, surface);
    const float v = edges(place >> kBlockShift, surface >> 5);
    const float w = edges(place >> (2 * kBlockShift), surface >> 10);
    const float x = x0 + xx * u + xy * v + xz * w;
    const float y = y0 + yx * u + yy * v + yz * w;
    const float z = z0 + zx * u + zy * v + zz * w;
    const float flat_squared = x * x + y * y;
    range_m[i] = std::sqrt(flat_squared + z * z);
    azimuth_rad[i] = fast_atan2(y, x);
    elevation_rad[i] = fast_atan2(z, std::sqrt(flat_squared));
  }
}

}  // namespace

void BlockProjection::project(const VoxelBlock& block, Asked asked, const Eigen::Vector3f& corner_sensor_m,
                              const ScanView& view, float voxel_m) {
  size_ = 0;
  std::uint16_t rank = 0;
  block.for_each([&](int place, const Voxel& voxel) {
    packed_[size_] = static_cast<std::uint32_t>(place) << 15 | voxel.surface;
    rank_[size_] = rank++;
    size_ += asked == Asked::kNotHit ? voxel.idle > 0 : asked == Asked::kKnown ? voxel.age > 0 : 1;
  });
  std::fill_n(packed_ + size_, kLanes, 0U);
  see(whole_lanes(), packed_, corner_sensor_m, view.R_sensor_map * voxel_m, azimuth_rad_, elevation_rad_,
      range_m_);
}

void BlockProjection::find_told(const ScanView& view, const std::vector<LevelModel>& models) {
  view.find_told(whole_lanes(), azimuth_rad_, elevation_rad_, range_m_, models, told_);
  told_size_ = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    told_at_[told_size_] = static_cast<std::uint16_t>(i);
    told_size_ += told_[i] != 0;
  }
}

}  // namespace stillmap
