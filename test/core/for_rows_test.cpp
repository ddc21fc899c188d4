// Rows that pass a test, found on all threads: in their order, none left out at the edges of pieces.
#include "core/for_rows.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

std::vector<std::uint32_t> one_by_one(std::size_t count, bool (*test)(std::size_t)) {
  std::vector<std::uint32_t> rows;
  for (std::size_t row = 0; row < count; ++row)
    if (test(row)) rows.push_back(static_cast<std::uint32_t>(row));
  return rows;
}

TEST(FindRows, AreThoseFoundOneByOne) {
  bool (*const tests[])(std::size_t) = {[](std::size_t) { return true; }, [](std::size_t) { return false; },
                                        [](std::size_t row) { return row % 3 == 0; },
                                        [](std::size_t row) { return row / 2048 % 2 == 1; },
                                        [](std::size_t row) { return row % 2048 == 2047; }};
  std::vector<std::uint32_t> rows = {7, 7};  // what was there before
  for (const std::size_t count : {0, 1, 2047, 2048, 2049, 20000})
    for (const auto test : tests) {
      find_rows(count, rows, test);
      EXPECT_EQ(rows, one_by_one(count, test)) << count;
    }
}

}  // namespace
}  // namespace stillmap
