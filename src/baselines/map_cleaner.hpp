#pragma once

#include "baselines/accumulated_map.hpp"
#include "baselines/removal_method.hpp"
#include "baselines/support_map.hpp"

namespace stillmap {

/// A method that takes points out of the finished, down-sampled map; a row has its map point's verdict.
class MapCleaner : public RemovalMethod {
 public:
  std::optional<PointVerdicts> add(const Frame& frame) override;
  void finish() override;
  PointVerdicts map_verdicts(std::size_t k, const Frame& frame) const override;

 protected:
  /// The returns of one scan.
  struct View {
    Eigen::Isometry3d T_map_sensor;
    std::vector<Eigen::Vector3f> returns;  ///< sensor frame
  };

  MapCleaner(double voxel_size_m, const GateSettings& gates)
      : map_(voxel_size_m), support_(voxel_size_m, gates) {}

  /// For each point 1 where it is dynamic.
  virtual std::vector<std::uint8_t> find_dynamic(const std::vector<Eigen::Vector3d>& points,
                                                 const std::vector<View>& views) const = 0;

 private:
  AccumulatedMap map_;
  SupportMap support_;
  std::vector<View> views_;
  std::vector<std::uint8_t> dynamic_;
};

}  // namespace stillmap
