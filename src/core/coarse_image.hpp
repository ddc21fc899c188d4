#pragma once

#include <cstdint>
#include <vector>

#include "scan_view.hpp"
#include "stillmap/range_image.hpp"

namespace stillmap {

/// A range image in tiles of some pixels: tells at once that a scan says nothing about a whole block. Most
/// blocks are hidden, or out of sight.
class CoarseImage {
 public:
  CoarseImage(const RangeImage& image, const LevelModel& level);

  /// False: no pixel supports or contradicts anything inside the ball.
  bool may_tell(const Spherical& center, float radius_m) const;

 private:
  /// In steps of the image's ranges.
  struct Tile {
    std::uint16_t
        farthest_conflict;  ///< the largest nearest return of a pixel: what is as far is not contradicted
    std::uint16_t farthest_support;  ///< the farthest return of a pixel that can be one surface
  };

  void summarise(const RangeImage& image, int tile_column);
  /// For elements at `nearest_m` and farther.
  bool may_tell(const Tile& tile, float nearest_m) const;

  static constexpr int kTileColumns = 4, kTileRows = 8;
  SphericalGrid grid_;
  LevelModel level_;
  float step_m_;
  int tile_columns_, tile_rows_;
  std::vector<Tile> tiles_;  ///< column by column
};

/// The same for all levels of a scan.
class CoarseView {
 public:
  CoarseView(const ScanView& view, const std::vector<LevelModel>& models);

  bool may_tell(const Eigen::Vector3f& center_sensor_m, float radius_m) const;

 private:
  std::vector<CoarseImage> levels_;
};

}  // namespace stillmap
