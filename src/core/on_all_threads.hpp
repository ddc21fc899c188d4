#pragma once

#include <tbb/task_arena.h>

#include <cstddef>

namespace stillmap {

/// The threads of one mapper: loops that run in it take no others.
class WorkerArena {
 public:
  explicit WorkerArena(int threads) : arena_(threads) {}

  template <class Work>
  void run(const Work& work) {
    run_call([](const void* called) { (*static_cast<const Work*>(called))(); }, &work);
  }

 private:
  void run_call(void (*call)(const void* work), const void* work);

  tbb::task_arena arena_;
};

/// Of the arena that this runs in.
int arena_threads();

/// Behind at_once.
void call_at_once(void (*call_first)(const void* work), const void* first,
                  void (*call_second)(const void* work), const void* second);

/// Calls first() on this thread and second() on another that is free, or after it: pieces of the one fill the
/// gaps where the other goes on alone.
template <class First, class Second>
void at_once(const First& first, const Second& second) {
  call_at_once([](const void* called) { (*static_cast<const First*>(called))(); }, &first,
               [](const void* called) { (*static_cast<const Second*>(called))(); }, &second);
}

/// Behind for_pieces, once for all kinds of work.
void call_for_pieces(std::size_t count, std::size_t at_once,
                     void (*call)(const void* work, std::size_t first, std::size_t last), const void* work);

/// Calls work(first, last) for pieces of 0 .. count - 1, on all threads; a piece of no more than at_once
/// stays whole.
template <class Work>
void for_pieces(std::size_t count, std::size_t at_once, const Work& work) {
  const auto call = [](const void* called, std::size_t first, std::size_t last) {
    (*static_cast<const Work*>(called))(first, last);
  };
  call_for_pieces(count, at_once, call, &work);
}

/// Calls work(i) for each i of 0 .. count - 1, on all threads.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
  for_pieces(count, 1, [&work](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) work(i);
  });
}

}  // namespace stillmap
