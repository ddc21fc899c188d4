#pragma once

#include <string>

#include "messages/lidars_in_bag.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// What becomes of the clouds.
enum class CleanForm { kRemoved, kMasked, kSplit, kLabels };

struct CleanJob {
  std::string in, out;
  CleanForm form = CleanForm::kRemoved;
  bool static_only = false;
  bool online = false;
};

/// Throws std::runtime_error when both are the same file.
void require_another_file(const std::string& in, const std::string& out);

/// Labels the LiDARs' clouds and copies its bag, atomically, message by message; clouds without a pose are
/// uncertain as a whole. Throws std::runtime_error on input or output that does not work.
void clean_bag(LidarsInBag& sequence, const Parameters& parameters, const CleanJob& job);

}  // namespace stillmap
