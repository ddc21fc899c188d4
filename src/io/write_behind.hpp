#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace stillmap {

/// Does what it is given, in that order, on a thread of its own: files are written while the next scan is
/// worked on.
class WriteBehind {
 public:
  WriteBehind();
  ~WriteBehind();  ///< what is still due is not done: finish() before
  WriteBehind(const WriteBehind&) = delete;
  WriteBehind& operator=(const WriteBehind&) = delete;

  /// Waits while too much is due. Throws what an earlier job threw; those after it are not done.
  void add(std::function<void()> job);
  /// Returns when all is done. Throws as add().
  void finish();
  double cpu_ms();  ///< that the jobs have taken so far

 private:
  void work();
  void throw_error();

  std::mutex mutex_;  ///< for all below
  std::condition_variable came_, done_;
  std::deque<std::function<void()>> jobs_;  ///< the first one is being done
  std::exception_ptr error_;
  bool closing_ = false;
  std::thread worker_;
};

}  // namespace stillmap
