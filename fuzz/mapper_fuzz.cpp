// Scans with any coordinates at any poses, as the conversions let them through: labelled, mapped, and out
// again.

#include <cmath>

#include "expect.hpp"
#include "input.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap::fuzz {
namespace {

Scan take_scan(Input& in) {
  Scan scan;
  scan.stamp_ns = in.take<std::int32_t>();
  for (std::size_t rows = in.choose(64); rows > 0 && !in.empty(); --rows) {
    Eigen::Vector3f& point = scan.points.emplace_back();
    const bool is_wild = in.choose(8) == 0;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = is_wild ? in.take<float>() : 0.1F * in.take<std::int8_t>();
  }
  return scan;
}

Eigen::Isometry3d take_pose(Input& in) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int axis = 0; axis < 3; ++axis)
    pose.translation()[axis] = in.choose(8) == 0 ? in.take<double>() : 0.1 * in.take<std::int8_t>();
  pose.linear() = Eigen::AngleAxisd(0.05 * in.take<std::int8_t>(), Eigen::Vector3d::UnitZ()).matrix();
  return pose;
}

/// Images are what an input costs: one in sixteen has them as large as a sensor's.
Parameters small_parameters(Input& in, bool has_large_images) {
  Parameters parameters;
  parameters.max_range_m = 15;
  parameters.history_recent = parameters.history_spread = 2;
  if (!has_large_images) {
    parameters.voxel_size_m = 2.0;
    parameters.ring_spacing_deg = parameters.azimuth_step_deg = 10.0;
    if (in.choose(4) != 0) parameters.angular_levels_deg = {5.0, 10.0};
  }
  parameters.rolling_radius_m = in.choose(2) ? 15 : 0;
  if (in.choose(4) == 0) parameters.evidence_goes_to = "nearest_voxel";
  return parameters;
}

void check(const ScanLabels& labels, const Scan& scan) {
  expect(labels.label.size() == scan.points.size(), "a label for each row");
  for (const float p : labels.p_static) expect(p >= 0 && p <= 1, "p_static is a probability");
}

void run(Input& in) {
  const bool has_large_images = in.choose(16) == 15;
  Mapper mapper(small_parameters(in, has_large_images));
  const int most_scans = has_large_images ? 2 : 6;
  for (int scans = 0; scans < most_scans && !in.empty(); ++scans) {
    const Eigen::Isometry3d pose = take_pose(in);
    const Scan scan = take_scan(in);
    try {
      const ScanLabels online = mapper.process(scan, pose);
      check(online, scan);
      check(mapper.relabel(scan, pose, online), scan);
    } catch (const std::invalid_argument&) {
      expect(!pose.matrix().allFinite() || pose.translation().cwiseAbs().maxCoeff() > 8e5,
             "only a pose out of reach is refused");
    }
  }
  const MapSnapshotPtr map = mapper.snapshot();
  for (const SnapshotVoxel& voxel : map->voxels)
    expect(voxel.center.allFinite() && std::isfinite(voxel.log_odds), "voxels are finite");
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stillmap::fuzz::Input in(data, size);
  stillmap::fuzz::run(in);
  return 0;
}
