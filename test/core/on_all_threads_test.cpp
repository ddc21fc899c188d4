// Work on all threads: every piece once, and ThreadSanitizer finds what is wrong in it although TBB is built
// without.
#include "core/on_all_threads.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace stillmap {
namespace {

constexpr std::size_t kThreads = 4;

/// Also where the machine has fewer.
class OnAllThreads : public testing::Test {
 protected:
  tbb::global_control allowed_{tbb::global_control::max_allowed_parallelism, kThreads};
  WorkerArena arena_{kThreads};
};

TEST_F(OnAllThreads, EveryPieceIsDoneOnceAndSeenAfterwards) {
  for (const std::size_t count : {0, 1, 7, 1000}) {
    std::vector<int> times(count, 0);
    std::vector<int> afterwards;
    arena_.run([&] {
      EXPECT_EQ(arena_threads(), static_cast<int>(kThreads));
      for_pieces(count, 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ++times[i];
      });
      for_each_index(count, [&](std::size_t i) { ++times[i]; });
      afterwards = times;
    });
    EXPECT_EQ(afterwards, std::vector<int>(count, 2));
  }
}

// Both wait for the other, which a single thread would do for ever.
TEST_F(OnAllThreads, TwoWorksGoOnAtOnce) {
  std::atomic<int> begun{0};
  const auto meet = [&begun] {
    for (++begun; begun < 2;) std::this_thread::yield();
  };
  std::vector<int> first(1000, 0), second(1000, 0);
  const auto fill = [](std::vector<int>& with_ones) {
    for_each_index(with_ones.size(), [&](std::size_t i) { ++with_ones[i]; });
  };
  arena_.run([&] {
    at_once([&] { meet(), fill(first); }, [&] { meet(), fill(second); });
    EXPECT_EQ(first, std::vector<int>(1000, 1));
    EXPECT_EQ(second, first);
  });
}

TEST_F(OnAllThreads, OneThreadDoesOneWorkAfterTheOther) {
  std::vector<std::string> done;
  WorkerArena one(1);
  one.run([&] {
    at_once([&] { for_each_index(2, [&](std::size_t) { done.push_back("first"); }); },
            [&] { done.push_back("second"); });
  });
  EXPECT_EQ(done, (std::vector<std::string>{"first", "first", "second"}));
}

TEST_F(OnAllThreads, ThreadSanitizerFindsARaceBetweenTwoPieces) {
#if defined(__SANITIZE_THREAD__)
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto race = [this] {
    std::atomic<int> arrived{0};
    long same_place = 0;
    arena_.run([&] {
      for_each_index(2, [&](std::size_t i) {
        arrived.fetch_add(1, std::memory_order_relaxed);  // orders nothing
        while (arrived.load(std::memory_order_relaxed) < 2) std::this_thread::yield();
        same_place += static_cast<long>(i);
      });
    });
    std::_Exit(same_place == 1 ? 0 : 1);
  };
  EXPECT_EXIT(race(), testing::ExitedWithCode(66), "data race");
#else
  GTEST_SKIP() << "built without ThreadSanitizer";
#endif
}

}  // namespace
}  // namespace stillmap
