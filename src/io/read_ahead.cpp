#include "io/read_ahead.hpp"

#include "io/thread_cpu.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kAhead = 4;  // scans; some 10 MB

}  // namespace

ReadAhead::ReadAhead(Sequence& sequence, std::vector<std::size_t> indices)
    : sequence_(sequence), indices_(std::move(indices)), worker_(&ReadAhead::work, this) {}

ReadAhead::~ReadAhead() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  taken_.notify_all();
  worker_.join();
}

Frame ReadAhead::next() {
  std::unique_lock lock(mutex_);
  came_.wait(lock, [this] { return !slots_.empty(); });
  Slot slot = std::move(slots_.front());
  slots_.pop_front();
  taken_.notify_one();
  if (slot.error) std::rethrow_exception(slot.error);
  return std::move(slot.frame);
}

double ReadAhead::cpu_ms() {
  return stillmap::cpu_ms(worker_);  // which lives as long as this does
}

ReadAhead::Slot ReadAhead::read(std::size_t index) {
  try {
    return {sequence_.read(index), nullptr};
  } catch (...) {  // goes to who takes the scan
    return {{}, std::current_exception()};
  }
}

void ReadAhead::work() {
  for (const std::size_t index : indices_) {
    Slot slot = read(index);
    std::unique_lock lock(mutex_);
    slots_.push_back(std::move(slot));
    came_.notify_one();
    taken_.wait(lock, [this] { return closing_ || slots_.size() < kAhead; });
    if (closing_) return;
  }
  // Stays until the end: cpu_ms() reads its clock.
  std::unique_lock lock(mutex_);
  taken_.wait(lock, [this] { return closing_; });
}

}  // namespace stillmap
