#include "structure_gates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stillmap {
namespace {

BlockKey cell_of(const Eigen::Vector3d& point_m) {
  return {static_cast<int>(std::floor(point_m.x())), static_cast<int>(std::floor(point_m.y())), 0};
}

}  // namespace

GateSettings gate_settings(const Parameters& parameters) {
  return {parameters.gate_voxel_support, parameters.gate_neighbourhood_support, parameters.gate_grid_support,
          parameters.gate_height_above_ground_m};
}

StructureGates::StructureGates(const VoxelMap& map, const GateSettings& settings)
    : map_(map), settings_(settings) {
  block_z_min_ = std::numeric_limits<int>::max();
  block_z_max_ = std::numeric_limits<int>::min();
  for (std::uint32_t index = 0; index < map_.block_count(); ++index) {
    if (map_.block(index).size() == 0) continue;
    block_z_min_ = std::min(block_z_min_, map_.block(index).key().z());
    block_z_max_ = std::max(block_z_max_, map_.block(index).key().z());
  }
  if (settings_.height_above_ground_m > 0) find_ground();
}

bool StructureGates::dynamic_may_stand(const VoxelKey& key) const {
  if (!few_points(key)) return false;
  return settings_.height_above_ground_m <= 0 || height_above_ground_m(key) > settings_.height_above_ground_m;
}

bool StructureGates::few_points(const VoxelKey& key) const {
  const bool by_voxel = settings_.voxel_support > 0;
  const bool by_surroundings = settings_.neighbourhood_support > 0 || settings_.grid_support > 0;
  if (!by_voxel && !by_surroundings) return true;
  if (by_voxel) {
    const Voxel* voxel = map_.find(key);
    if (voxel == nullptr || voxel->hits < settings_.voxel_support) return true;
    if (!by_surroundings) return false;
  }
  if (settings_.neighbourhood_support > 0 && neighbourhood_support(key) >= settings_.neighbourhood_support)
    return false;
  return settings_.grid_support <= 0 || column_support(key) < settings_.grid_support;
}

int StructureGates::neighbourhood_support(const VoxelKey& key) const {
  int points = 0;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (const Voxel* voxel = map_.find(key + VoxelKey(dx, dy, dz))) points += voxel->hits;
  return points;
}

int StructureGates::column_support(const VoxelKey& key) const {
  int points = 0;
  for (int block_z = block_z_min_; block_z <= block_z_max_; ++block_z) {
    const VoxelKey lowest(key.x(), key.y(), block_z * kBlockEdge);
    const std::int64_t index = map_.find_block(block_key(lowest));
    if (index < 0) continue;
    const VoxelBlock& block = map_.block(static_cast<std::uint32_t>(index));
    for (int step = 0; step < kBlockEdge; ++step) {
      const int place = place_in_block(lowest + VoxelKey(0, 0, step));
      if (block.contains(place)) points += block.at(place).hits;
    }
  }
  return points;
}

void StructureGates::find_ground() {
  for (std::uint32_t index = 0; index < map_.block_count(); ++index) {
    const VoxelBlock& block = map_.block(index);
    block.for_each([&](int place, const Voxel&) {
      const Eigen::Vector3d center = map_.center_of(voxel_key(block.key(), place));
      const auto z = static_cast<float>(center.z());
      auto [cell, created] = lowest_m_.try_emplace(packed(cell_of(center)), z);
      if (!created) cell.value() = std::min(cell.value(), z);
    });
  }
}

double StructureGates::height_above_ground_m(const VoxelKey& key) const {
  // The lower quartile around: a wall's foot or a car's side may lie far above the ground, and a reflection
  // below it.
  constexpr int kReach = 2;
  const Eigen::Vector3d center = map_.center_of(key);
  std::vector<float> around;
  for (int dy = -kReach; dy <= kReach; ++dy)
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const auto cell = lowest_m_.find(packed(cell_of(center) + BlockKey(dx, dy, 0)));
      if (cell != lowest_m_.end()) around.push_back(cell->second);
    }
  if (around.empty()) return std::numeric_limits<double>::infinity();
  const auto nth = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 4);
  std::nth_element(around.begin(), nth, around.end());
  return center.z() - *nth;
}

}  // namespace stillmap
