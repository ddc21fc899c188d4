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
  static const float GH = env("GH", 0.2), DD = env("DD", .15), DR = env("DR", .6), SS = env("SS", .3), SR = env("SR", .9), DN = env("DN", 4), VF = env("VF", .5), VG=env("VG",3), VN=env("VN",4), VS=env("VS",.1);
  static const int ON = env("ON", 1), VV = env("VV", 1), GS = env("GS", 1);
  if (!ON) return;
  ground.fit(scan, projected, R);
  row_flags.assign(n, 0);
  std::vector<std::uint8_t> is_ground(n, 0);
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
        if (view.evidence(view.to_sensor(o), models).kind() == Evidence::kConflict) { ++v.vanished; break; }
      }
    }
  }
  for (std::size_t row = 0; row < n; ++row) {
    const std::int32_t c = clusters.of_row()[row];
    if (is_ground[row] && labels.label[row] == Label::kUncertain && GS) {
      labels.label[row] = Label::kStatic; labels.reason[row] = Reason::kObjectStands; continue; }
    if (c < 0 || labels.label[row] != Label::kUncertain) continue;
    const Votes& v = votes[c];
    const float decided = v.dynamic + v.is_static;
    if (v.dynamic >= DN && v.dynamic >= DD * v.rows && v.dynamic >= DR * decided) {
      labels.label[row] = Label::kDynamic; labels.reason[row] = Reason::kObjectMoves;
    } else if (v.is_static >= SS * v.rows && v.is_static >= SR * decided) {
      labels.label[row] = Label::kStatic; labels.reason[row] = Reason::kObjectStands;
    } else if (v.vanished >= VN && v.vanished >= VF * v.undecided && v.is_static <= VS * v.rows) {
      labels.label[row] = Label::kDynamic; labels.reason[row] = Reason::kReplacedVanished;
    }
  }
  static const float OF = env("OF", 30), OS = env("OS", 0.8), GN = env("GN", 3);
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
      if (sz < OF && sf > OS) { labels.label[row] = Label::kUncertain; }
    }
  }
}

}  // namespace stillmap
