#include "evaluation/injected_sequence.hpp"

#include <stdexcept>

#include "baselines/removal_method.hpp"
#include "evaluation/target_paths.hpp"
#include "simulation/surface.hpp"
#include "stillmap/range_image.hpp"

namespace stillmap {
namespace {

using simulation::Random;
using simulation::Ray;

constexpr std::uint16_t kFirstInstance = 60'001;  // out of the way of the recorded ones
constexpr float kPixel_rad = 0.01745329252F;      // of the image that tells what stands before a target
constexpr float kMaxRange_m = 500.0F;
constexpr double kBefore_m = 0.3;

void check(const InjectionOptions& options) {
  const auto require = [](bool good, const char* message) {
    if (!good) throw std::invalid_argument(message);
  };
  require(options.people >= 0 && options.vehicles >= 0, "targets: a count below 0");
  require(options.vehicle_size_m.size() == 3, "vehicle size: expected three lengths in metres");
  for (const double length_m : options.vehicle_size_m)
    require(length_m > 0, "vehicle size: a length is not above 0 m");
  require(options.person_height_m > 0.5, "person height: not above 0.5 m");
  require(options.speed_mps > 0, "speed: not above 0 m/s; a target that stands is not moving");
}

Ray ray_to(const Eigen::Vector3d& origin, const Eigen::Vector3d& point) {
  return {origin, (point - origin).normalized()};
}

/// Every fifth scan, thinned: enough to find free ground.
RecordedScene look_at(LabelledSequence& sequence, std::uint64_t seed) {
  RecordedScene scene;
  std::int64_t first_stamp_ns = 0;
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    LabelledFrame scan = sequence.read(k);
    if (k == 0) first_stamp_ns = scan.frame.scan.stamp_ns;
    scene.sensor_places.push_back(scan.frame.T_map_sensor.translation());
    scene.times_s.push_back(1e-9 * static_cast<double>(scan.frame.scan.stamp_ns - first_stamp_ns));
    if (k % 5 != 0) continue;
    thin_out(scan, 20'000, seed, k);
    for (const Eigen::Vector3f& point : scan.frame.scan.points)
      scene.points.push_back(scan.frame.T_map_sensor * point.cast<double>());
  }
  return scene;
}

RangeImage image_of(const Scan& scan) {
  ProjectedScan projected;
  project(scan, 0.1F, kMaxRange_m, projected);
  return RangeImage::nearest(projected, kPixel_rad, kMaxRange_m);
}

/// Whether the recorded scan measured something before this point of a target.
bool is_hidden(const RangeImage& image, const Eigen::Vector3f& point_sensor_m) {
  const Spherical seen = spherical(point_sensor_m);
  const MeasuredRange measured = image.at(seen.azimuth_rad, seen.elevation_rad);
  return measured.valid() && measured.nearest_m < seen.range_m - kBefore_m;
}

}  // namespace

InjectedSequence::InjectedSequence(std::unique_ptr<LabelledSequence> background,
                                   const InjectionOptions& options)
    : background_(std::move(background)), options_(options) {
  check(options_);
  std::uint16_t instance = kFirstInstance;
  for (int i = 0; i < options_.people; ++i)
    targets_.push_back(make_person_target(options_.person_height_m, options_.person_points, instance++));
  const Eigen::Vector3d size_m = Eigen::Map<const Eigen::Vector3d>(options_.vehicle_size_m.data());
  for (int i = 0; i < options_.vehicles; ++i)
    targets_.push_back(make_vehicle_target(size_m, options_.vehicle_points, instance++));
  const RecordedScene scene = look_at(*background_, options_.seed);
  first_stamp_ns_ = background_->read(0).frame.scan.stamp_ns;
  Random random(options_.seed);
  std::vector<TargetPath> taken;
  for (InjectedTarget& target : targets_) {
    target.path = choose_path(scene, target.size_m, options_.speed_mps, taken, random);
    taken.push_back(target.path);
  }
}

void InjectedSequence::hide_behind_targets(LabelledFrame& scan, double time_s) const {
  const Eigen::Vector3d origin = scan.frame.T_map_sensor.translation();
  for (Eigen::Vector3f& point : scan.frame.scan.points) {
    if (!is_return(point)) continue;
    const Eigen::Vector3d place = scan.frame.T_map_sensor * point.cast<double>();
    for (const InjectedTarget& target : targets_) {
      const auto range_m = target.range_m(ray_to(origin, place), time_s);
      if (range_m && *range_m < (place - origin).norm()) point.setZero();
    }
  }
}

bool InjectedSequence::is_behind_another(const InjectedTarget& target, const Eigen::Vector3d& origin,
                                         const Eigen::Vector3d& place, double time_s) const {
  for (const InjectedTarget& other : targets_) {
    if (&other == &target) continue;
    const auto range_m = other.range_m(ray_to(origin, place), time_s);
    if (range_m && *range_m < (place - origin).norm()) return true;
  }
  return false;
}

LabelledFrame InjectedSequence::read(std::size_t index) {
  LabelledFrame scan = background_->read(index);
  const double time_s = 1e-9 * static_cast<double>(scan.frame.scan.stamp_ns - first_stamp_ns_);
  const RangeImage image = image_of(scan.frame.scan);
  if (!options_.overlay) hide_behind_targets(scan, time_s);
  if (options_.max_points > 0) thin_out(scan, options_.max_points, options_.seed, index);

  const Eigen::Isometry3d T_sensor_map = scan.frame.T_map_sensor.inverse();
  const Eigen::Vector3d origin = scan.frame.T_map_sensor.translation();
  Random random(options_.seed, index + 1);
  for (const InjectedTarget& target : targets_) {
    const auto places =
        options_.overlay ? target.all_over(time_s, random) : target.seen_from(origin, time_s, random);
    for (const Eigen::Vector3d& place : places) {
      const Eigen::Vector3f point = (T_sensor_map * place).cast<float>();
      if (!options_.overlay && (is_hidden(image, point) || is_behind_another(target, origin, place, time_s)))
        continue;
      scan.frame.scan.points.push_back(point);
      scan.labels.push_back(target.label);
      scan.labels_now.push_back(target.label);
    }
  }
  return scan;
}

LabelledFrame StandingSequence::read(std::size_t index) {
  LabelledFrame scan;
  scan.frame = scans_->read(index);
  scan.labels.assign(scan.frame.scan.points.size(), simulation::kOther);
  scan.labels_now = scan.labels;
  return scan;
}

}  // namespace stillmap
