#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace stillmap {

/// A line on stderr with share done, rate and time left. Draws nothing where stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar(std::string title, std::size_t total);
  ~ProgressBar();  ///< ends the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance();  ///< one more is done

 private:
  void draw();

  using Clock = std::chrono::steady_clock;
  std::string title_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool on_terminal_;
  Clock::time_point start_;
  Clock::time_point last_draw_;
};

}  // namespace stillmap
