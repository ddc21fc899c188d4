#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "io/sequence.hpp"

namespace stillmap {

/// Reads the scans of a sequence on a thread of its own, a few ahead of who takes them.
class ReadAhead {
 public:
  /// Only this may use the sequence meanwhile, and it must live as long.
  ReadAhead(Sequence& sequence, std::vector<std::size_t> indices);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// The next of `indices`, to be called once for each. Throws what reading it threw.
  Frame next();
  double cpu_ms();  ///< that reading has taken so far

 private:
  struct Slot {
    Frame frame;
    std::exception_ptr error;
  };
  Slot read(std::size_t index);
  void work();

  Sequence& sequence_;
  const std::vector<std::size_t> indices_;
  std::mutex mutex_;  ///< for all below
  std::condition_variable came_, taken_;
  std::deque<Slot> slots_;
  bool closing_ = false;
  std::thread worker_;
};

}  // namespace stillmap
