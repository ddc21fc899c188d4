#include "mapper_state.hpp"

namespace stillmap {
namespace {
float env(const char* n, float d) { const char* e = getenv(n); return e ? atof(e) : d; }

/// What the rows of a cluster say.
struct Votes {
  int rows = 0, dynamic = 0, is_static = 0, undecided = 0, vanished = 0, tested = 0;
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
  std::vector<Votes> votes(clusters.count());
  const ScanView* last = history.recent(1);
  const ScanView* last2 = history.recent(2);
  for (std::size_t row = 0; row < n; ++row) {
    const std::int32_t c = clusters.of_row()[row];
    if (c < 0) continue;
    Votes& v = votes[c];
    ++v.rows;
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
        ++v.tested;
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
    ++v.rows;
    if (labels.label[row] == Label::kDynamic) ++v.dynamic;
    else if (labels.label[row] == Label::kStatic) ++v.is_static;
    else { ++v.undecided; v.vanished += row_vanished[row]; }
  }
  for (std::size_t row = 0; row < n; ++row) {
    const std::int32_t c = clusters.of_row()[row];
    if (is_ground[row] && labels.label[row] == Label::kUncertain && GS) {
      labels.label[row] = Label::kStatic; labels.reason[row] = Reason::kObjectStands; continue; }
    if (c < 0 || labels.label[row] != Label::kUncertain) continue;
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
}

}  // namespace stillmap
