#include "tools/progress_bar.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace stillmap {

ProgressBar::ProgressBar(std::string title, std::size_t total)
    : title_(std::move(title)),
      total_(total),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_draw_(start_) {
  if (on_terminal_) draw();
}

ProgressBar::~ProgressBar() {
  if (on_terminal_) std::fputc('\n', stderr);
}

void ProgressBar::advance() {
  ++done_;
  if (!on_terminal_) return;
  const auto now = Clock::now();
  if (done_ < total_ && now - last_draw_ < std::chrono::milliseconds(100)) return;
  last_draw_ = now;
  draw();
}

void ProgressBar::draw() {
  constexpr int kWidth = 30;
  const double share = total_ > 0 ? static_cast<double>(done_) / static_cast<double>(total_) : 1.0;
  const int filled = static_cast<int>(share * kWidth);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(kWidth - filled), '.');
  const double elapsed_s = std::chrono::duration<double>(last_draw_ - start_).count();
  const double rate_hz = elapsed_s > 0 ? static_cast<double>(done_) / elapsed_s : 0.0;
  const double left_s = rate_hz > 0 ? static_cast<double>(total_ - done_) / rate_hz : 0.0;
  std::fprintf(stderr, "\r%s [%s] %zu/%zu  %.1f/s  %d:%02d left \033[K", title_.c_str(), bar.c_str(), done_,
               total_, rate_hz, static_cast<int>(left_s) / 60, static_cast<int>(left_s) % 60);
  std::fflush(stderr);
}

}  // namespace stillmap
