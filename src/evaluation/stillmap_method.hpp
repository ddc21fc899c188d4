#pragma once

#include "baselines/removal_method.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {

/// This package's own method behind the interface that all share.
class StillmapMethod : public RemovalMethod {
 public:
  explicit StillmapMethod(const Parameters& parameters) : mapper_(parameters) {}

  std::optional<PointVerdicts> add(const Frame& frame) override;
  void finish() override {}
  PointVerdicts map_verdicts(std::size_t k, const Frame& frame) const override;
  std::string settings() const override;

 private:
  Mapper mapper_;
  std::vector<ScanLabels> online_;  ///< of every scan: a final verdict starts from it
};

}  // namespace stillmap
