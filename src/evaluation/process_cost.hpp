#pragma once

#include <optional>

namespace stillmap {

/// CPU time of this process, all threads, in the stretches between start() and stop().
class CpuMeter {
 public:
  void start();
  void stop();
  double total_ms() const { return total_ms_; }

 private:
  double started_ms_ = 0, total_ms_ = 0;
};

/// How far the process's memory grows over what it held at the start.
class MemoryMeter {
 public:
  MemoryMeter();  ///< gives freed memory back first
  /// Nothing where the kernel does not tell.
  std::optional<double> peak_mb() const;

 private:
  std::optional<double> start_mb_;
};

}  // namespace stillmap
