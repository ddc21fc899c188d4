#include "mapper_state.hpp"

namespace stillmap {
namespace {

/// A voxel in view of the scan.
struct InView {
  Voxel* voxel;
  Spherical seen;
  FusedEvidence evidence;
};

/// I_M of one level: the nearest voxel of each pixel gets the pixel's evidence, eq. (2).
void judge_nearest(std::vector<InView>& in_view, const RangeImage& image, const LevelModel& model) {
  constexpr std::int32_t kNobody = -1;
  std::vector<std::int32_t> nearest(image.grid().size(), kNobody);
  for (std::size_t i = 0; i < in_view.size(); ++i) {
    const int pixel = image.grid().pixel(in_view[i].seen.azimuth_rad, in_view[i].seen.elevation_rad);
    if (pixel < 0) continue;
    std::int32_t& best = nearest[pixel];
    if (best == kNobody || in_view[i].seen.range_m < in_view[best].seen.range_m)
      best = static_cast<std::int32_t>(i);
  }
  for (std::size_t pixel = 0; pixel < nearest.size(); ++pixel) {
    if (nearest[pixel] == kNobody) continue;
    InView& element = in_view[nearest[pixel]];
    const MeasuredRange measured = image.at(static_cast<int>(pixel));
    const float range_m = element.seen.range_m;
    element.evidence.add(classify(range_m, measured, model), range_m, measured, model);
  }
}

}  // namespace

void Mapper::State::apply_evidence_to_nearest(const ScanView& view) {
  std::vector<InView> in_view;
  map.find_near(view.origin_map_m, reach_m(), near_tiles);
  for (const BlockTile* tile : near_tiles)
    for (const BlockEntry& entry : *tile) {
      VoxelBlock& block = map.block(entry.index);
      block.age(scan_count);
      block.for_each([&](int place, Voxel& voxel) {
        const Eigen::Vector3d in_edges =
            voxel_key(entry.key, place).cast<double>() + voxel.surface_offset().cast<double>();
        const Spherical seen = spherical(view.to_sensor(in_edges * map.voxel_size_m()));
        if (seen.range_m <= parameters.max_range_m) in_view.push_back({&voxel, seen, FusedEvidence{}});
      });
    }
  for (std::size_t r = 0; r < models.size(); ++r) judge_nearest(in_view, view.levels()[r], models[r]);
  for (InView& element : in_view) {
    if (parameters.hit_is_support && element.voxel->idle == 0) element.evidence = own_hit;
    if (element.evidence.kind() == Evidence::kUnknown) continue;
    if (element.evidence.kind() == Evidence::kConflict) element.voxel->see_through();
    const float log_odds = element.voxel->log_odds();
    element.voxel->set_log_odds(recursion(log_odds, element.evidence.increment(log_odds)));
  }
}

}  // namespace stillmap
