#pragma once

#include <memory>

#include "messages/bag_sequence.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {

/// Opens a bag as the options say; what the bag lacks is told on stderr. Throws std::runtime_error.
std::unique_ptr<BagSequence> open_bag(const SequenceOptions& options);

}  // namespace stillmap
