#include "ros/node_doctor.hpp"

#include <ros/console.h>

#include <algorithm>

namespace stillmap {

void NodeDoctor::look_at(const PairedScan& paired, const ScanLabels& labels) {
  if (doctor_.is_done()) return;
  for (const Finding& finding : doctor_.add(paired.scan, paired.T_map_sensor, count(labels))) tell(finding);
}

void NodeDoctor::look_at(const InputFacts& facts) {
  for (const Finding& finding : check_input(facts)) tell(finding);
}

void NodeDoctor::tell(const Finding& finding) {
  const auto is_it = [&](const Finding& told) { return told.check == finding.check; };
  const auto told = std::find_if(findings_.begin(), findings_.end(), is_it);
  if (told != findings_.end()) return;
  findings_.push_back(finding);
  ROS_WARN_STREAM("doctor: " << finding.check << ": " << finding.text);
}

}  // namespace stillmap
