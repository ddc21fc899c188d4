#include "io/write_behind.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <vector>

#include "support/expect_error.hpp"

namespace stillmap {
namespace {

TEST(WriteBehind, DoesAllInTheirOrderBeforeItIsFinished) {
  std::vector<int> done;
  WriteBehind behind;
  for (int i = 0; i < 20; ++i) behind.add([&done, i] { done.push_back(i); });
  behind.finish();
  ASSERT_EQ(done.size(), 20U);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(done[i], i);
  EXPECT_GE(behind.cpu_ms(), 0);
}

TEST(WriteBehind, TellsWhatFailedAndDoesNothingAfterIt) {
  std::atomic<int> done{0};
  WriteBehind behind;
  behind.add([] { throw std::runtime_error("file 7: the disk is full"); });
  expect_error([&] { behind.finish(); }, {"file 7"});
  expect_error([&] { behind.add([&done] { ++done; }); }, {"file 7"});
  EXPECT_EQ(done, 0);
}

TEST(WriteBehind, HasWhoGivesTooMuchWait) {
  std::atomic<bool> may_go_on{false};
  std::atomic<int> added{0};
  WriteBehind behind;
  std::thread giver([&] {
    for (int i = 0; i < 10; ++i, ++added)
      behind.add([&may_go_on] {
        while (!may_go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      });
  });
  for (int i = 0; i < 1000 && added < 4; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(added, 4);
  may_go_on = true;
  giver.join();
  behind.finish();
}

}  // namespace
}  // namespace stillmap
