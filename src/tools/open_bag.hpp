#pragma once

#include <memory>

#include "messages/lidars_in_bag.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {

/// Opens a bag as the options say, with a progress bar; what the bag lacks is told on stderr. Throws
/// std::runtime_error.
std::unique_ptr<LidarsInBag> open_bag(const SequenceOptions& options);

}  // namespace stillmap
