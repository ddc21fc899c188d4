#include "io/read_ahead.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

#include "support/expect_error.hpp"

namespace stillmap {
namespace {

class Numbered : public Sequence {
 public:
  std::size_t size() const override { return 100; }
  Frame read(std::size_t index) override {
    ++reads;
    if (index == 13) throw std::runtime_error("scan 13: unreadable");
    Frame frame;
    frame.name = std::to_string(index);
    return frame;
  }
  std::atomic<int> reads{0};
};

TEST(ReadAhead, GivesTheScansInTheirOrder) {
  Numbered numbered;
  ReadAhead ahead(numbered, {5, 7, 6, 99});
  for (const std::string name : {"5", "7", "6", "99"}) EXPECT_EQ(ahead.next().name, name);
  EXPECT_GE(ahead.cpu_ms(), 0);
}

TEST(ReadAhead, AnUnreadableScanIsToldInItsTurn) {
  Numbered numbered;
  ReadAhead ahead(numbered, {12, 13, 14});
  EXPECT_EQ(ahead.next().name, "12");
  expect_error([&] { ahead.next(); }, {"scan 13"});
  EXPECT_EQ(ahead.next().name, "14");
}

TEST(ReadAhead, ReadsAFewAheadAndEndsWhenItIsLeft) {
  Numbered numbered;
  std::vector<std::size_t> indices(100, 1);
  {
    const ReadAhead ahead(numbered, indices);
    for (int i = 0; i < 1000 && numbered.reads < 4; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_EQ(numbered.reads, 4);
}

}  // namespace
}  // namespace stillmap
