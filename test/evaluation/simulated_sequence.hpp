#pragma once

#include <utility>
#include <vector>

#include "evaluation/labelled_sequence.hpp"
#include "simulation/simulator.hpp"

namespace stillmap {

/// Cast once, read often.
class SimulatedSequence : public LabelledSequence {
 public:
  explicit SimulatedSequence(const SimulationOptions& options) {
    const Simulator simulator(options);
    for (std::size_t k = 0; k < simulator.size(); ++k) {
      SimulatedFrame frame = simulator.frame(k);
      scans_.push_back({std::move(frame.frame), std::move(frame.labels), std::move(frame.labels_now)});
    }
  }
  std::size_t size() const override { return scans_.size(); }
  LabelledFrame read(std::size_t index) override { return scans_.at(index); }

 private:
  std::vector<LabelledFrame> scans_;
};

}  // namespace stillmap
