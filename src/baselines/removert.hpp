#pragma once

#include "baselines/map_cleaner.hpp"

namespace stillmap {

/// Kim and Kim, "Remove, then Revert: Static Point cloud Map Construction using Multiresolution Range
/// Images", IROS 2020; the defaults are the authors' for KITTI (pixels of 1/2.5, 1/2, 1/1.5 degrees; 1 to
/// 1/0.7).
struct RemovertSettings {
  double voxel_size_m = 0.05;  ///< of the map
  std::vector<double> remove_pixels_deg = {0.4, 0.5, 0.6667};
  std::vector<double> revert_pixels_deg = {1.0, 1.1111, 1.25, 1.4286};
  double range_share = 0.05;  ///< of a map point's range: what the scan must be farther by to see through it
  GateSettings gates;

  static RemovertSettings published();
  static RemovertSettings paper();  ///< with section 2.1
};

/// Removes map points that a scan sees through, in fine range images; then reverts those that no scan sees
/// through in a coarser one.
class Removert : public MapCleaner {
 public:
  explicit Removert(const RemovertSettings& settings)
      : MapCleaner(settings.voxel_size_m, settings.gates), settings_(settings) {}
  std::string settings() const override;

 protected:
  std::vector<std::uint8_t> find_dynamic(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<View>& views) const override;

 private:
  RemovertSettings settings_;
};

}  // namespace stillmap
