#include "io/write_behind.hpp"

#include "io/thread_cpu.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kBehind = 4;  // scans; some 10 MB

}  // namespace

WriteBehind::WriteBehind() : worker_(&WriteBehind::work, this) {}

WriteBehind::~WriteBehind() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  came_.notify_all();
  worker_.join();
}

void WriteBehind::add(std::function<void()> job) {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return error_ || jobs_.size() < kBehind; });
  throw_error();
  jobs_.push_back(std::move(job));
  came_.notify_one();
}

void WriteBehind::finish() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return error_ || jobs_.empty(); });
  throw_error();
}

double WriteBehind::cpu_ms() {
  return stillmap::cpu_ms(worker_);
}

void WriteBehind::throw_error() {
  if (error_) std::rethrow_exception(error_);
}

void WriteBehind::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    came_.wait(lock, [this] { return closing_ || (!error_ && !jobs_.empty()); });
    if (closing_) return;
    const std::function<void()>& job = jobs_.front();
    lock.unlock();
    std::exception_ptr error;
    try {
      job();
    } catch (...) {  // goes to who gives the next job
      error = std::current_exception();
    }
    lock.lock();
    error_ = error;
    jobs_.pop_front();
    done_.notify_all();
  }
}

}  // namespace stillmap
