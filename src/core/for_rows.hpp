#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace stillmap {

/// Calls work(first, last) for pieces of 0 .. count - 1, on all threads: for loops of a few instructions a
/// row.
template <class Work>
void for_rows(std::size_t count, Work&& work) {
  constexpr std::size_t kAtOnce = 2048;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kAtOnce),
                    [&](const tbb::blocked_range<std::size_t>& rows) { work(rows.begin(), rows.end()); });
}

}  // namespace stillmap
