#pragma once

#include <array>
#include <chrono>
#include <numeric>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// Wall time of each stage of one scan.
class StageTimer : public StageListener {
 public:
  void start() {
    stage_ms.fill(0);
    go_on();
  }
  /// What was done since the last stage is of none.
  void go_on() { last_ = Clock::now(); }
  void stage_ended(Stage stage) override {
    const auto now = Clock::now();
    stage_ms[static_cast<std::size_t>(stage)] =
        std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }

  double total_ms() const { return std::accumulate(stage_ms.begin(), stage_ms.end(), 0.0); }

  std::array<double, kStageCount> stage_ms{};

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_;
};

}  // namespace stillmap
