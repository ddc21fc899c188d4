#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

namespace stillmap {

/// A spatial element i. 8 bytes; a voxel that is not there was never hit.
struct Voxel {
  std::int16_t log_odds_fixed = 0;  ///< L of eq. (1), in steps of 1 / kLogOddsScale
  std::uint16_t surface = kCentre;  ///< where in the voxel its returns lie: 5 bits an axis, x lowest
  std::uint8_t hits = 0;            ///< scans that returned from it, saturating
  std::uint8_t idle = 0;            ///< scans since it was last hit, saturating; see VoxelBlock::age()
  std::uint8_t age = 0;             ///< scans since it was first hit, likewise
  std::uint8_t seen_through : 6;    ///< scans that saw through it, saturating
  std::uint8_t moved_in : 1;        ///< when it was first hit, earlier scans had seen through its place
  std::uint8_t came_back : 1;       ///< hit again after it was seen through, as porous things are

  Voxel() : seen_through(0), moved_in(0), came_back(0) {}

  static constexpr float kLogOddsScale = 2048.0F;
  float log_odds() const { return log_odds_fixed / kLogOddsScale; }
  void set_log_odds(float value) {
    log_odds_fixed = static_cast<std::int16_t>(value * kLogOddsScale + (value < 0 ? -0.5F : 0.5F));
  }

  /// A return of the present scan from it; `offset` is its place in voxel edges from the low corner. Scans of
  /// `sensors` LiDARs come in turn.
  void hit(const Eigen::Vector3f& offset, std::size_t sensors = 1) {
    const bool first = hits == 0;
    if (first || idle > 0) {
      came_back = came_back || (seen_through > 0 && idle > sensors);
      if (hits < 0xFF) ++hits;
    }
    idle = 0;
    if (first)
      set_surface(offset);
    else
      surface = static_cast<std::uint16_t>(moved(surface, offset.x()) | moved(surface >> 5, offset.y()) << 5 |
                                           moved(surface >> 10, offset.z()) << 10);
  }
  void set_surface(const Eigen::Vector3f& offset) {
    surface = static_cast<std::uint16_t>(bits(offset.x()) | bits(offset.y()) << 5 | bits(offset.z()) << 10);
  }
  void grow_older(std::uint32_t scans) {
    idle = static_cast<std::uint8_t>(std::min(255U, idle + scans));
    age = static_cast<std::uint8_t>(std::min(255U, age + scans));
  }
  void see_through() {
    if (seen_through < 0x3F) seen_through = static_cast<std::uint8_t>(seen_through + 1) & 0x3F;
  }
  /// Mean place of its returns, in voxel edges from the low corner.
  Eigen::Vector3f surface_offset() const {
    constexpr float kStep = 1.0F / 32.0F;
    return {((surface & 31) + 0.5F) * kStep, ((surface >> 5 & 31) + 0.5F) * kStep,
            ((surface >> 10 & 31) + 0.5F) * kStep};
  }

 private:
  static constexpr std::uint16_t kCentre = 16 | 16 << 5 | 16 << 10;
  /// One axis of the surface after one more return: between two places in the voxel, so that it needs no
  /// bounds.
  static unsigned moved(unsigned before_bits, float offset) {
    constexpr float kNewReturn = 0.25F;  // weight against the returns before
    const float before = static_cast<float>(static_cast<int>(before_bits & 31)) + 0.5F;
    return static_cast<unsigned>(static_cast<int>(before + kNewReturn * (offset * 32.0F - before)));
  }
  static unsigned bits(float offset) {
    return static_cast<unsigned>(static_cast<int>(std::min(std::max(offset * 32.0F, 0.0F), 31.0F)));
  }
};
static_assert(sizeof(Voxel) == 8);

}  // namespace stillmap
