#include "baselines/octomap_baseline.hpp"

#include <octomap/octomap.h>

#include "baselines/settings_text.hpp"

namespace stillmap {
namespace {

constexpr double kSupportVoxel_m = 0.05;  // table 1

octomap::point3d to_octomap(const Eigen::Vector3d& point) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())};
}

}  // namespace

OctomapSettings OctomapSettings::published() {
  return {};
}

OctomapSettings OctomapSettings::paper() {
  OctomapSettings settings;
  // Not given by section 2.1. Of 0.1 to 0.8 m the one that serves OctoMap best on 8000 points a scan: finer
  // voxels are passed by too few rays.
  settings.voxel_size_m = 0.4;
  settings.gates.voxel_support = 4;
  return settings;
}

OctomapBaseline::OctomapBaseline(const OctomapSettings& settings)
    : settings_(settings),
      tree_(std::make_unique<octomap::OcTree>(settings.voxel_size_m)),
      support_(kSupportVoxel_m, settings.gates) {
  tree_->setProbHit(settings.p_hit);
  tree_->setProbMiss(settings.p_miss);
  tree_->setClampingThresMin(settings.p_min);
  tree_->setClampingThresMax(settings.p_max);
}

OctomapBaseline::~OctomapBaseline() = default;

std::optional<PointVerdicts> OctomapBaseline::add(const Frame& frame) {
  octomap::Pointcloud cloud;
  for (const Eigen::Vector3f& point : frame.scan.points)
    if (is_return(point)) cloud.push_back(to_octomap(frame.T_map_sensor * point.cast<double>()));
  constexpr double kAnyRange = -1;
  constexpr bool kLazy = true;
  tree_->insertPointCloud(cloud, to_octomap(frame.T_map_sensor.translation()), kAnyRange, kLazy);
  support_.add(frame);
  return std::nullopt;
}

void OctomapBaseline::finish() {
  tree_->updateInnerOccupancy();
}

PointVerdicts OctomapBaseline::map_verdicts(std::size_t, const Frame& frame) const {
  const StructureGates gates = support_.gates();
  PointVerdicts verdicts;
  verdicts.label.assign(frame.scan.points.size(), Label::kInvalid);
  for (std::size_t row = 0; row < frame.scan.points.size(); ++row) {
    if (!is_return(frame.scan.points[row])) continue;
    const Eigen::Vector3d point = frame.T_map_sensor * frame.scan.points[row].cast<double>();
    const octomap::OcTreeNode* node = tree_->search(to_octomap(point));
    const bool dynamic = node == nullptr || !tree_->isNodeOccupied(node);
    const bool may_stand = !support_.enabled() || gates.dynamic_may_stand(support_.key_of(point));
    verdicts.label[row] = dynamic && may_stand ? Label::kDynamic : Label::kStatic;
  }
  return verdicts;
}

std::string OctomapBaseline::settings() const {
  return SettingsText()
      .add("voxel_size_m", settings_.voxel_size_m)
      .add("p_hit", settings_.p_hit)
      .add("p_miss", settings_.p_miss)
      .add("p_min", settings_.p_min)
      .add("p_max", settings_.p_max)
      .add(settings_.gates)
      .text();
}

}  // namespace stillmap
