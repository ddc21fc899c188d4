#pragma once

#include <cstdint>

#include "io/sequence.hpp"

namespace stillmap {

/// A sequence driven again and again: each lap begins one step after the end of the lap before, moved
/// there without turning, and later by the lap's time. For sequences whose end looks where their start looks.
class LoopedSequence : public Sequence {
 public:
  /// `lap` must have two scans and outlive this. Throws std::runtime_error like its read().
  LoopedSequence(Sequence& lap, std::size_t size);

  std::size_t size() const override { return size_; }
  Frame read(std::size_t index) override;

 private:
  Sequence& lap_;
  std::size_t size_;
  Eigen::Vector3d lap_way_map_m_;
  std::int64_t lap_time_ns_ = 0;
};

}  // namespace stillmap
