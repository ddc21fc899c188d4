#pragma once

#include <string>
#include <vector>

#include "doctor/doctor.hpp"
#include "doctor/input_facts.hpp"
#include "messages/scan_pairing.hpp"

namespace stillmap {

/// The doctor beside the node: tells each finding once on the console, and keeps them for /diagnostics. For
/// the worker alone.
class NodeDoctor {
 public:
  explicit NodeDoctor(const PairingOptions& said) : doctor_(said) {}

  void look_at(const PairedScan& paired, const ScanLabels& labels);
  void look_at(const InputFacts& facts);
  const std::vector<Finding>& findings() const { return findings_; }
  std::size_t scans() const { return doctor_.scans(); }

 private:
  void tell(const Finding& finding);

  Doctor doctor_;
  std::vector<Finding> findings_;
};

}  // namespace stillmap
