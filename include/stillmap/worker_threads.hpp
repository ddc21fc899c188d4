#pragma once

#include <string>

#include "stillmap/parameters.hpp"

namespace stillmap {

/// The parameter `threads`, but no more than this machine gives the process: TBB would warn on its own.
int worker_threads(const Parameters& parameters);

/// What to tell when `threads` asks for more than that; empty when it does not.
std::string threads_message(const Parameters& parameters);

}  // namespace stillmap
