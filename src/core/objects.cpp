#include "mapper_state.hpp"

namespace stillmap {
namespace {
float env(const char* n, float d) { const char* e = getenv(n); return e ? atof(e) : d; }

/// What the rows of a cluster say.
struct Votes {
  int rows = 0, dynamic = 0, is_static = 0, undecided = 0, vanished = 0, followed = 0, old_static = 0;
};

}  // namespace

void Mapper::State::resolve_objects(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const ScanView& view) {
  const std::size_t n = scan.points.size();
  const Eigen::Matrix3f R = T_map_sensor.linear().cast<float>();
  static const float GH = env("GH", 0.1), DD = env("DD", .15), DR = env("DR", .6), SS = env("SS", .3), SR = env("SR", .9), DN = env("DN", 4), VF = env("VF", .5), VG=env("VG",3), VN=env("VN",4), VS=env("VS",.1);
  static const int ON = env("ON", 1), VV = env("VV", 1), GS = env("GS", 1);
  if (!ON) return;
  ground.fit(scan, projected, R);
  row_flags.assign(n, 0);
  std::vector<std::uint8_t> is_ground(n, 0), row_vanished(n, 0);
  for (std::size_t row = 0; row < n; ++row) {
    if (!voxel_of_row[row].exists()) continue;
    const float h = ground.height_above(R * scan.points[row]);
    if (h < GH) is_ground[row] = 1; else row_flags[row] = 1;
  }
  clusters.find(scan, projected, beams, row_flags);
  static const int FO = env("FO", 1), FA = env("FA", 2), YA = env("YA", 10); static const float FF = env("FF", .5), FS = env("FS", .1);
  std::vector<std::uint8_t> followed(n, 0), old_static(n, 0);
  {
    std::uint32_t lastb = VoxelRef::kNone; CellMask mask = 0;
    for (std::size_t row = 0; row < n; ++row) {
      if (clusters.of_row()[row] < 0) continue;
      const VoxelRef ref = voxel_of_row[row];
      if (ref.block != lastb) {
        lastb = ref.block;
        std::array<CellMask, 27> around{}; bool any = false;
        if (FO) for (int i = 0; i < 27; ++i) {
          const std::int64_t index = map.find_block(map.block(lastb).key() + BlockKey(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
          if (index < 0) continue;
          const VoxelBlock& block = map.block(static_cast<std::uint32_t>(index));
          if (block.moving_scan + FA >= scan_count && block.moving) { around[i] = block.moving; any = true; }
        }
        mask = any ? grown(around) : 0;
      }
      followed[row] = mask >> cell_of_place(ref.place) & 1;
      if (labels.label[row] == Label::kStatic) old_static[row] = map.block(ref.block).at(ref.place).first_seen >= YA;
    }
  }
  std::vector<Votes> votes(clusters.count());
  const ScanView* last = history.recent(1);
  const ScanView* last2 = history.recent(2);
  for (std::size_t row = 0; row < n; ++row) {
    const std::int32_t c = clusters.of_row()[row];
    if (c < 0) continue;
    Votes& v = votes[c];
    ++v.rows; v.followed += followed[row]; v.old_static += old_static[row];
    if (labels.label[row] == Label::kDynamic) ++v.dynamic;
    else if (labels.label[row] == Label::kStatic) ++v.is_static;
    else {
      ++v.undecided;
      if (VV) for (const ScanView* past : {last, last2}) {
        if (!past) continue;
        const Eigen::Vector3d p = T_map_sensor * scan.points[row].cast<double>();
        const Eigen::Vector3f q = past->to_sensor(p);
        const Spherical s = spherical(q);
        const MeasuredRange m = past->levels()[0].at(s.azimuth_rad, s.elevation_rad);
        if (!m.valid()) continue;
        const float I = m.farthest_m;
        if (s.range_m - I < 0.1f || s.range_m - I > VG) continue;
        const Eigen::Vector3d o = past->origin_map_m + (p - past->origin_map_m) * (I / s.range_m);
        if (view.evidence(view.to_sensor(o), models).kind() == Evidence::kConflict) { ++v.vanished; row_vanished[row] = 1; break; }
      }
    }
  }
  static const int PT = env("PT", 1); static const float PS = env("PS", 1.0), PD = env("PD", .1), PR_=env("PR",.6), PSS=env("PSS",.5), PSR=env("PSR",.9), PN=env("PN",4), PVF=env("PVF",.5);
  const auto verdict = [&](const Votes& v, float dn, float dd, float dr, float ss, float sr, float vf) {
    const float decided = v.dynamic + v.is_static;
    if (v.dynamic >= dn && v.dynamic >= dd * v.rows && v.dynamic >= dr * decided) return Reason::kObjectMoves;
    if (FO && v.followed >= FF * v.rows && v.followed >= dn && v.old_static <= FS * v.rows) return Reason::kObjectMoves;
    if (v.is_static >= ss * v.rows && v.is_static >= sr * decided) return Reason::kObjectStands;
    if (v.vanished >= VN && v.vanished >= vf * v.undecided && v.is_static <= VS * v.rows) return Reason::kReplacedVanished;
    return Reason::kMixedEvidence;
  };
  tsl::robin_map<std::uint64_t, Votes, BlockKeyHash> patches;
  const auto patch_key = [&](std::size_t row) {
    const Eigen::Vector3i k = ((R * scan.points[row]) / PS).array().floor().cast<int>();
    return packed(k) ^ (static_cast<std::uint64_t>(clusters.of_row()[row]) * 0x9E3779B97F4A7C15ULL);
  };
  if (PT) for (std::size_t row = 0; row < n; ++row) {
    const std::int32_t c = clusters.of_row()[row];
    if (c < 0) continue;
    Votes& v = patches[patch_key(row)];
    ++v.rows; v.followed += followed[row]; v.old_static += old_static[row];
    if (labels.label[row] == Label::kDynamic) ++v.dynamic;
    else if (labels.label[row] == Label::kStatic) ++v.is_static;
    else { ++v.undecided; v.vanished += row_vanished[row]; }
  }
  for (std::size_t row = 0; row < n; ++row) {
    const std::int32_t c = clusters.of_row()[row];
    if (is_ground[row] && labels.label[row] == Label::kUncertain && GS) {
      labels.label[row] = Label::kStatic; labels.reason[row] = Reason::kObjectStands; continue; }
    static const int YO = env("YO", 0);
    if (c < 0 || !(labels.label[row] == Label::kUncertain || (YO && labels.label[row] == Label::kStatic && !old_static[row]))) continue;
    Reason why = Reason::kMixedEvidence;
    if (PT) why = verdict(patches[patch_key(row)], PN, PD, PR_, PSS, PSR, PVF);
    if (why == Reason::kMixedEvidence) why = verdict(votes[c], DN, DD, DR, SS, SR, VF);
    if (why == Reason::kMixedEvidence) continue;
    labels.label[row] = why == Reason::kObjectStands ? Label::kStatic : Label::kDynamic;
    labels.reason[row] = why;
  }
  static const float OF = env("OF", .3), OS = env("OS", 0.8), GN = env("GN", 3);
  if (OF > 0) {
    std::vector<std::uint8_t> dyn(n, 0);
    for (std::size_t row = 0; row < n; ++row) dyn[row] = voxel_of_row[row].exists() && labels.label[row] == Label::kDynamic;
    static Clusters dc; dc.find(scan, projected, beams, dyn);
    std::vector<int> size(dc.count(), 0);
    for (std::size_t row = 0; row < n; ++row) if (dc.of_row()[row] >= 0) size[dc.of_row()[row]]++;
    for (std::size_t row = 0; row < n; ++row) if (dyn[row]) {
      const int sz = dc.of_row()[row] >= 0 ? size[dc.of_row()[row]] : 1;
      const std::int32_t c = clusters.of_row()[row];
      float sf = c < 0 ? (sz < GN ? 1 : 0) : votes[c].is_static / std::max(1.f, (float)(votes[c].is_static + votes[c].dynamic));
      const float ar = OF / projected.range_m[row]; const float need = std::min(200.f, std::max(3.f, ar * ar / (beams.ring_spacing_rad * beams.azimuth_step_rad)));
      if (sz < need && sf > OS) { labels.label[row] = Label::kUncertain; }
    }
  }
  for (std::size_t row = 0; row < n; ++row) {
    if (labels.label[row] != Label::kDynamic || clusters.of_row()[row] < 0) continue;
    VoxelBlock& block = map.block(voxel_of_row[row].block);
    if (block.moving_scan != scan_count) { block.moving_scan = scan_count; block.moving = 0; }
    block.moving |= CellMask{1} << cell_of_place(voxel_of_row[row].place);
  }
}

}  // namespace stillmap
