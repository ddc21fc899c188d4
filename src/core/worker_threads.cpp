#include "stillmap/worker_threads.hpp"

#include <tbb/global_control.h>

#include <algorithm>

namespace stillmap {

int worker_threads(const Parameters& parameters) {
  const auto most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(parameters.threads, static_cast<int>(most));
}

std::string threads_message(const Parameters& parameters) {
  const int used = worker_threads(parameters);
  if (used == parameters.threads) return "";
  return "parameter threads is " + std::to_string(parameters.threads) + ": this machine gives " +
         std::to_string(used) + ", so " + std::to_string(used) + " are used";
}

}  // namespace stillmap
