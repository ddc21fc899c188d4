#pragma once

#include <pthread.h>

#include <ctime>
#include <thread>

namespace stillmap {

/// What a thread that has not ended has taken so far.
inline double cpu_ms(std::thread& thread) {
  clockid_t clock;
  timespec time{};
  pthread_getcpuclockid(thread.native_handle(), &clock);
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace stillmap
