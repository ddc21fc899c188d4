#pragma once

#include <memory>

#include "baselines/removal_method.hpp"
#include "baselines/support_map.hpp"

namespace octomap {
class OcTree;
}

namespace stillmap {

/// Hornung et al., "OctoMap: An Efficient Probabilistic 3D Mapping Framework Based on Octrees", Autonomous
/// Robots 2013; the defaults are those of the library and of octomap_server.
struct OctomapSettings {
  double voxel_size_m = 0.05;
  double p_hit = 0.7, p_miss = 0.4;
  double p_min = 0.12, p_max = 0.97;  ///< clamping
  GateSettings gates;

  static OctomapSettings published();
  static OctomapSettings paper();  ///< with section 2.1
};

/// liboctomap: every ray clears the voxels that it passes; what does not end up occupied is taken out.
class OctomapBaseline : public RemovalMethod {
 public:
  explicit OctomapBaseline(const OctomapSettings& settings);
  ~OctomapBaseline() override;

  std::optional<PointVerdicts> add(const Frame& frame) override;
  void finish() override;
  PointVerdicts map_verdicts(std::size_t k, const Frame& frame) const override;
  std::string settings() const override;

 private:
  OctomapSettings settings_;
  std::unique_ptr<octomap::OcTree> tree_;
  SupportMap support_;
};

}  // namespace stillmap
