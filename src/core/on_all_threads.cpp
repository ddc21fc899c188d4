#include "on_all_threads.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#if defined(STILLMAP_TELLS_TSAN)
#include <sanitizer/tsan_interface.h>
#endif

namespace stillmap {
namespace {

/// Lives around work that TBB does on several threads. Distributions build TBB without ThreadSanitizer, which
/// then sees neither how work goes to a thread nor how it comes back: it is told here, and only that. Shares
/// of the work stay unordered among each other, so their races are found. TBB's templates are in this file
/// alone, which is compiled without ThreadSanitizer, as TBB is.
class ThreadHandover {
 public:
#if defined(STILLMAP_TELLS_TSAN)
  ThreadHandover() {
    __tsan_release(&given_);
  }
  ~ThreadHandover() {
    __tsan_acquire(&returned_);
  }
  void take() {
    __tsan_acquire(&given_);
  }
  void give_back() {
    __tsan_release(&returned_);
  }

 private:
  char given_ = 0, returned_ = 0;  // one alone would order a share after what another share had done
#else
  void take() {}
  void give_back() {}
#endif
};

struct Share {
  explicit Share(ThreadHandover& from) : handover(from) { handover.take(); }
  ~Share() { handover.give_back(); }
  ThreadHandover& handover;
};

}  // namespace

void WorkerArena::run_call(void (*call)(const void* work), const void* work) {
  ThreadHandover handover;
  arena_.execute([&] {
    const Share share(handover);
    call(work);
  });
}

int arena_threads() {
  return tbb::this_task_arena::max_concurrency();
}

void call_at_once(void (*call_first)(const void* work), const void* first,
                  void (*call_second)(const void* work), const void* second) {
  if (arena_threads() == 1) {
    call_first(first);
    call_second(second);
    return;
  }
  ThreadHandover handover;
  tbb::task_group group;
  group.run([&] {
    const Share share(handover);
    call_second(second);
  });
  call_first(first);
  group.wait();
}

void call_for_pieces(std::size_t count, std::size_t at_once,
                     void (*call)(const void* work, std::size_t first, std::size_t last), const void* work) {
  ThreadHandover handover;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, at_once),
                    [&](const tbb::blocked_range<std::size_t>& piece) {
                      const Share share(handover);
                      call(work, piece.begin(), piece.end());
                    });
}

}  // namespace stillmap
