#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "on_all_threads.hpp"

namespace stillmap {

/// Calls work(first, last) for pieces of 0 .. count - 1, on all threads: for loops of a few instructions a
/// row.
template <class Work>
void for_rows(std::size_t count, const Work& work) {
  for_pieces(count, 2048, work);
}

/// The rows of 0 .. count - 1 for which the test holds, in their order; tested on all threads.
template <class Test>
void find_rows(std::size_t count, std::vector<std::uint32_t>& rows, Test&& test) {
  constexpr std::size_t kAtOnce = 2048;
  const std::size_t pieces = (count + kAtOnce - 1) / kAtOnce;
  std::vector<std::size_t> found(pieces);  // in each piece, which has its own place in `room`
  const std::unique_ptr<std::uint32_t[]> room(new std::uint32_t[pieces * kAtOnce]);  // not set to zero first
  for_each_index(pieces, [&](std::size_t piece) {
    std::uint32_t* const begin = &room[piece * kAtOnce];
    std::uint32_t* end = begin;
    for (std::size_t row = piece * kAtOnce; row < std::min(count, (piece + 1) * kAtOnce); ++row) {
      *end = static_cast<std::uint32_t>(row);
      end += test(row) ? 1 : 0;  // no branch that would be foretold wrongly
    }
    found[piece] = static_cast<std::size_t>(end - begin);
  });
  rows.clear();
  for (std::size_t piece = 0; piece < pieces; ++piece)
    rows.insert(rows.end(), &room[piece * kAtOnce], &room[piece * kAtOnce] + found[piece]);
}

}  // namespace stillmap
