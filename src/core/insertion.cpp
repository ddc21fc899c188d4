#include <algorithm>
#include <array>

#include "mapper_state.hpp"
#include "vector_clones.hpp"

namespace stillmap {

void Mapper::State::insert() {
  find_hit_blocks();
  sort_rows_by_block();
  // Each block has its own rows, in the scan's order.
  for_each_hit_block([this](HitBlock& hit) { insert_rows(hit); });
  new_voxels.clear();
  for (const HitBlock& hit : hit_blocks)
    for (std::uint32_t i = 0; i < hit.new_count; ++i) new_voxels.push_back(made_by_block[hit.first_row + i]);
  map.count_created(new_voxels.size());
}

void Mapper::State::find_hit_blocks() {
  // Rings come to the same blocks again and again: the last ones are remembered, each key in a place of its
  // own.
  struct Recent {
    std::uint64_t key = LocatedRows::kNowhere;
    std::uint32_t hit = 0;
  };
  constexpr std::size_t kRecent = 8192;
  std::array<Recent, kRecent> recent;
  hit_blocks.clear();
  block_runs.clear();
  const auto rows = static_cast<std::uint32_t>(projected.size());
  const std::uint64_t* const block = located.block.data();
  for (std::uint32_t row = 0, end; row < rows; row = end) {
    const std::uint64_t key = block[row];
    for (end = row + 1; end < rows && block[end] == key;) ++end;
    if (key == LocatedRows::kNowhere) continue;
    Recent& entry = recent[BlockKeyHash{}(key) % kRecent];
    if (entry.key != key) entry = {key, hit_of_block(key)};
    block_runs.push_back({entry.hit, row, end});
    hit_blocks[entry.hit].row_count += end - row;
  }
}

std::uint32_t Mapper::State::hit_of_block(std::uint64_t packed_key) {
  const std::uint32_t index = map.find_or_create_block(unpacked(packed_key));
  if (index >= last_hits.size()) last_hits.resize(map.block_count());
  LastHit& last = last_hits[index];
  if (last.scan != scan_count) {
    last = {scan_count, static_cast<std::uint32_t>(hit_blocks.size())};
    hit_blocks.push_back({&map.block(index), index});
  }
  return last.hit;
}

void Mapper::State::sort_rows_by_block() {
  std::uint32_t rows = 0;
  for (HitBlock& hit : hit_blocks) {
    hit.first_row = rows;
    rows += hit.row_count;
    hit.row_count = 0;
  }
  rows_by_block.resize(rows);
  ranks_by_block.resize(rows);
  made_by_block.resize(rows);
  for (const BlockRun& run : block_runs) {
    HitBlock& hit = hit_blocks[run.hit];
    for (std::uint32_t row = run.first; row < run.last; ++row)
      rows_by_block[hit.first_row + hit.row_count++] = row;
  }
}

STILLMAP_VECTOR_CLONES void Mapper::State::insert_rows(HitBlock& hit) {
  VoxelBlock& block = *hit.block;
  block.age(scan_count);
  block.hit_scan = scan_count;
  const std::uint32_t* rows = &rows_by_block[hit.first_row];
  PlaceMask returned{};
  for (std::uint32_t i = 0; i < hit.row_count; ++i) {
    const std::uint16_t place = located.place[rows[i]];
    returned[place >> 6] |= std::uint64_t{1} << (place & 63);
  }
  PlaceMask made = block.create(returned);
  const Eigen::Vector3f centre = Eigen::Vector3f::Constant(0.5F);
  const std::size_t lidars = sensors.size();
  for (std::uint32_t i = 0; i < hit.row_count; ++i) {
    const std::uint16_t place = located.place[rows[i]];
    const int rank = block.rank(place);
    block.stored(rank).hit(parameters.surface_in_voxel ? located.offset(rows[i]) : centre, lidars);
    ranks_by_block[hit.first_row + i] = static_cast<std::uint16_t>(rank);
    const std::uint64_t bit = std::uint64_t{1} << (place & 63);
    if ((made[place >> 6] & bit) == 0) continue;
    made[place >> 6] &= ~bit;  // by its first return
    made_by_block[hit.first_row + hit.new_count++] = {rows[i], hit.index, place,
                                                      static_cast<std::uint16_t>(rank)};
  }
  if (!every_voxel_is_judged) return;
  find_known_surface(block);
  if (parameters.hit_is_support) support_returned(block, returned);
}

}  // namespace stillmap
