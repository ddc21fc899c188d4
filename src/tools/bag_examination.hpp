#pragma once

#include <string>
#include <vector>

#include "doctor/finding.hpp"
#include "messages/bag_topics.hpp"
#include "ros/node_parameters.hpp"

namespace stillmap {

/// What a bag has that the node could take.
struct BagContents {
  TopicCounts clouds, odometry;
  std::vector<std::string> tf_roots;  ///< frames of tf that have no parent
};
/// Throws std::runtime_error when there are no clouds.
BagContents contents_of(const std::string& bag);

/// The preset both of whose topics are in the bag; else generic.
std::string preset_for(const BagContents& contents);

/// A topic that is not in the bag gives way to the bag's only one. Throws std::runtime_error naming the
/// topics when there are several.
void choose_topics(const BagContents& contents, NodeParameters& node);

struct BagExamination {
  std::vector<Finding> findings;
  std::size_t scans = 0;
  double way_m = 0;
};
/// Labels the first scans as the node would and has the doctor look at them.
BagExamination examine(const std::string& bag, const NodeParameters& node);

}  // namespace stillmap
