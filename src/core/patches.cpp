#include <tsl/robin_map.h>

#include <array>

#include "mapper_state.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// The cube of 1 m that a row lies in.
BlockKey patch_cell(float x_m, float y_m, float z_m) {
  const auto floor = [](float value) {  // std::floor is a call
    const int whole = static_cast<int>(value);
    return whole - (value < static_cast<float>(whole));
  };
  return {floor(x_m), floor(y_m), floor(z_m)};
}

constexpr std::size_t kAtOnce = 1024;

/// The patches that n rows lie in.
STILLMAP_VECTOR_CLONES void find_patches(std::size_t n, const std::uint32_t* __restrict rows,
                                         const float* __restrict x_m, const float* __restrict y_m,
                                         const float* __restrict z_m, std::uint64_t* __restrict patch) {
  for (std::size_t i = 0; i < n; ++i) patch[i] = packed(patch_cell(x_m[rows[i]], y_m[rows[i]], z_m[rows[i]]));
}

/// Patches of one object have keys of their own.
std::uint64_t object_hash(std::int32_t object) {
  return BlockKeyHash{}(static_cast<std::uint64_t>(object) + 1);
}

}  // namespace

void Mapper::State::count_votes() {
  runs.resize((standing_rows.size() + kAtOnce - 1) / kAtOnce);
  for_each_index(runs.size(), [this](std::size_t piece) {
    runs[piece].clear();
    find_runs(piece * kAtOnce, std::min(standing_rows.size(), (piece + 1) * kAtOnce), runs[piece]);
  });
  object_votes.assign(clusters.count(), Votes{});
  tsl::robin_map<std::uint64_t, std::uint32_t, BlockKeyHash> patches;
  patches.reserve(patch_votes.size());  // about as many as in the last scan
  patch_votes.clear();
  for (std::vector<PatchRun>& piece : runs)
    for (PatchRun& run : piece) {
      const auto [patch, created] =
          patches.try_emplace(run.key, static_cast<std::uint32_t>(patch_votes.size()));
      if (created) patch_votes.emplace_back();
      run.patch = patch->second;
      object_votes[run.object] += run.votes;
      patch_votes[run.patch] += run.votes;
    }
}

void Mapper::State::find_runs(std::size_t first, std::size_t last, std::vector<PatchRun>& found) const {
  constexpr float kLeaning = 0.45F;  // p_static
  std::array<std::uint64_t, kAtOnce> patch;
  find_patches(last - first, &standing_rows[first], upright.x_m.data(), upright.y_m.data(),
               upright.z_m.data(), patch.data());
  const std::size_t begin = first;
  while (first < last) {
    const std::int32_t object = clusters.of_row()[standing_rows[first]];
    const std::uint64_t key = patch[first - begin];
    Votes votes;
    std::size_t i = first;
    for (; i < last; ++i) {
      const std::uint32_t row = standing_rows[i];
      if (clusters.of_row()[row] != object || patch[i - begin] != key) break;
      votes.add(labels.label[row], {is_established(row), followed[row] != 0,
                                    parameters.lean_together && labels.p_static[row] < kLeaning,
                                    parameters.spare_porous && on_porous[row] != 0});
    }
    if (object != Clusters::kNone)
      found.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(i), object, 0,
                       key ^ object_hash(object), votes});
    first = i;
  }
}

}  // namespace stillmap
