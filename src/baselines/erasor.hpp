#pragma once

#include "baselines/ground_plane.hpp"
#include "baselines/map_cleaner.hpp"

namespace stillmap {

/// Lim et al., "ERASOR: Egocentric Ratio of Pseudo Occupancy-based Dynamic Object Removal for Static 3D Point
/// Cloud Map Building", RA-L 2021; the defaults are the authors' for SemanticKITTI.
struct ErasorSettings {
  double voxel_size_m = 0.2;  ///< of the map
  double max_range_m = 80.0;
  int rings = 20, sectors = 108;
  double min_height_m = -1.3, max_height_m = 3.0;  ///< of the volume of interest, above the ground
  double free_height_m = 0.2;  ///< a bin of the map that reaches no higher is free of objects
  double scan_ratio = 0.2;     ///< pseudo occupancy of scan over map, below which a bin is dynamic
  int min_points = 6;          ///< in a bin, of scan and map, for it to be tested
  GroundPlaneSettings ground;
  GateSettings gates;

  static ErasorSettings published();
  static ErasorSettings paper();  ///< with section 2.1
};

/// Compares the height span of scan and map in each polar bin around the sensor; where the scan spans much
/// less, all of the map's points but the ground are taken out.
class Erasor : public MapCleaner {
 public:
  explicit Erasor(const ErasorSettings& settings)
      : MapCleaner(settings.voxel_size_m, settings.gates), settings_(settings) {}
  std::string settings() const override;

 protected:
  std::vector<std::uint8_t> find_dynamic(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<View>& views) const override;

 private:
  ErasorSettings settings_;
};

}  // namespace stillmap
