#include "evaluation/process_cost.hpp"

#include <malloc.h>

#include <ctime>
#include <fstream>
#include <string>

namespace stillmap {
namespace {

double cpu_now_ms() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

std::optional<double> status_mb(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == key && status >> kilobytes) return kilobytes / 1024.0;
  return std::nullopt;
}

}  // namespace

void CpuMeter::start() {
  started_ms_ = cpu_now_ms();
}

void CpuMeter::stop() {
  total_ms_ += cpu_now_ms() - started_ms_;
}

MemoryMeter::MemoryMeter() {
  malloc_trim(0);
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;  // the peak starts anew
  if (clear) start_mb_ = status_mb("VmRSS:");
}

std::optional<double> MemoryMeter::peak_mb() const {
  const std::optional<double> peak_mb = status_mb("VmHWM:");
  if (!start_mb_ || !peak_mb) return std::nullopt;
  return *peak_mb - *start_mb_;
}

}  // namespace stillmap
