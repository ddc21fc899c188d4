#include <array>

#include "cluster_links.hpp"
#include "clusters.hpp"

namespace stillmap {

inline std::int32_t Clusters::root(std::int32_t pixel) {
  while (parent_[pixel] != pixel) pixel = parent_[pixel] = parent_[parent_[pixel]];
  return pixel;
}

inline void Clusters::join(std::int32_t a, std::int32_t b) {
  if (parent_[a] == parent_[b]) return;
  const std::int32_t root_a = root(a), root_b = root(b), least = std::min(root_a, root_b);
  parent_[root_a] = parent_[root_b] = parent_[a] = parent_[b] = least;
}

void Clusters::join_column(int column, unsigned steps) {
  std::array<std::int32_t, kPixelSteps.size()> to;
  for (std::size_t k = 0; k < kPixelSteps.size(); ++k)
    to[k] = (column + kPixelSteps[k].columns) % grid_.columns * grid_.rows + kPixelSteps[k].rows;
  for (int row = used_[column].low; row < used_[column].high; ++row)
    for (unsigned links = links_[column * grid_.rows + row] & steps; links != 0; links &= links - 1)
      join(column * grid_.rows + row, to[__builtin_ctz(links)] + row);
}

void Clusters::join_stripe(int first, int last, std::vector<std::int32_t>& roots) {
  const auto each_used_pixel = [&](auto&& work) {
    for (int column = first; column < last; ++column)
      for (int row = used_[column].low; row < used_[column].high; ++row) work(column * grid_.rows + row);
  };
  each_used_pixel([this](std::int32_t pixel) { parent_[pixel] = pixel; });
  for (int column = first; column < last; ++column) {
    std::uint16_t* links = &links_[static_cast<std::size_t>(column) * static_cast<std::size_t>(grid_.rows)];
    thin_links(used_[column].low, used_[column].high, grid_.rows, links,
               column + 1 < last ? links + grid_.rows : links);
    join_column(column, steps_within(last - 1 - column));
  }
  roots.clear();
  each_used_pixel([&](std::int32_t pixel) {
    parent_[pixel] = parent_[parent_[pixel]];  // those before are roots' children by now
    if (parent_[pixel] == pixel && nearest_[pixel] != kNothing) roots.push_back(pixel);
  });
}

void Clusters::join_stripes() {
  for (int column = 0; column < grid_.columns; ++column) {
    const int last = std::min(column / kStripe * kStripe + kStripe, grid_.columns);
    const unsigned beyond = kEveryStep & ~steps_within(last - 1 - column);
    if (beyond != 0) join_column(column, beyond);
  }
  count_ = 0;
  for (const std::vector<std::int32_t>& roots : roots_)
    for (const std::int32_t pixel : roots)
      if (parent_[pixel] == pixel) name_[pixel] = static_cast<std::int32_t>(count_++);
}

}  // namespace stillmap
