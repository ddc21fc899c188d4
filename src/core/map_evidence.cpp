#include "mapper_state.hpp"

namespace stillmap {
namespace {
constexpr std::uint8_t kReturned = 0x80;
}

void Mapper::State::apply_evidence(const ScanView& view) {
  const float reach = static_cast<float>(parameters.max_range_m + map.block_size_m());
  const Eigen::Matrix3f step = view.R_sensor_map * static_cast<float>(map.voxel_size_m());
  static const float W = getenv("W") ? atof(getenv("W")) : .15;
  for (std::uint32_t index = 0; index < map.block_count(); ++index) {
    VoxelBlock& block = map.block(index);
    const Eigen::Vector3f corner = view.to_sensor(voxel_key(block.key(), 0).cast<double>() * map.voxel_size_m());
    if (corner.norm() > reach) continue;
    bool have_standing = false;
    CellMask standing = 0;
    block.for_each([&](int place, Voxel& voxel) {
      const bool hit = block.last_hit == scan_count && voxel.idle == 0;
      FusedEvidence evidence;
      if (hit && parameters.hit_is_support) {
        for (const LevelModel& model : models) evidence.support(model);
      } else {
        const VoxelKey key = voxel_key(BlockKey(0, 0, 0), place);
        evidence = view.evidence(corner + step * (key.cast<float>() + voxel.surface_offset()), models);
      }
      float increment = 0;
      switch (evidence.kind()) {
        case Evidence::kUnknown:
        case Evidence::kOcclusion: return;
        case Evidence::kSupport:
          increment = hit && (voxel.conflicts & kReturned) ? support_increment(models[0].eta, p_from_log_odds(voxel.log_odds())) : evidence.increment(voxel.log_odds());
          break;
        case Evidence::kConflict:
          if (!have_standing) {
            standing = near_standing_surface(block.key());
            have_standing = true;
          }
          increment = evidence.increment(voxel.log_odds());
          if (standing >> cell_of_place(place) & 1) increment *= W;
          voxel.conflicts = voxel.conflicts < 127 ? voxel.conflicts + 1 : voxel.conflicts;
      }
      voxel.set_log_odds(recursion(voxel.log_odds(), increment));
    });
  }
}

}  // namespace stillmap
