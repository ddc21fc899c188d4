// Tiles that come and go, against a map that keeps everything.
#include "core/rolling_map.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "core/tile_packing.hpp"
#include "core/tiles_in_a_table.hpp"
#include "core/voxel_reader.hpp"
#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

bool same(const BlockContents& a, const BlockContents& b) {
  return a.key == b.key && a.porous == b.porous && a.occupied == b.occupied &&
         a.voxels.size() == b.voxels.size() &&
         std::memcmp(a.voxels.data(), b.voxels.data(), a.voxels.size() * sizeof(Voxel)) == 0;
}

void hit(VoxelMap& map, const BlockKey& key, int place, std::uint32_t scan, float log_odds) {
  VoxelBlock& block = map.block(map.find_or_create_block(key));
  block.age(scan);
  bool created = false;
  Voxel& voxel = block.find_or_create(place, created);
  voxel.hit(Eigen::Vector3f(0.1F, 0.7F, log_odds / 8 + 0.5F));
  voxel.set_log_odds(log_odds);
  if (place % 7 == 0) voxel.see_through();
  block.porous |= cell_bit(place);
  map.count_created(created);
}

/// A scan from there, whose hits come later.
void visit(RollingMap& rolling, const Eigen::Vector3d& origin_map_m, std::uint32_t scan) {
  rolling.move_to(origin_map_m);
  rolling.leave(origin_map_m, scan);
}

/// Goes out and back along x, hits voxels around itself, and compares all that is near.
void expect_nothing_is_lost(double memory_m, TileStore* store) {
  constexpr double kOpen_m = 20, kHit_m = 14;
  VoxelMap plain(0.1), map(0.1);
  RollingMap rolling(map, kOpen_m, memory_m);
  rolling.set_store(store);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> around_m(-kHit_m, kHit_m);
  std::size_t most_open = 0;
  for (std::uint32_t scan = 1; scan <= 400; ++scan) {
    const Eigen::Vector3d origin(scan <= 200 ? 1.0 * scan : 400.0 - 1.0 * scan, 3, 0);
    visit(rolling, origin, scan);
    for (int i = 0; i < 30; ++i) {
      const Eigen::Vector3d place = origin + Eigen::Vector3d(around_m(random), around_m(random), 1);
      const VoxelKey key = plain.key_of(place);
      const auto log_odds = static_cast<float>(around_m(random) / 4);
      hit(plain, block_key(key), place_in_block(key), scan, log_odds);
      hit(map, block_key(key), place_in_block(key), scan, log_odds);
    }
    most_open = std::max(most_open, map.voxel_count());
    plain.for_each_tile_near(origin, kOpen_m, [&](const TileKey& key) {
      const BlockTile* const expected = plain.tile(key);
      const std::vector<BlockContents> found = rolling.contents(key, scan);
      ASSERT_EQ(found.size(), expected == nullptr ? 0 : expected->size());
      for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_TRUE(same(found[i], plain.block((*expected)[i].index).contents(scan))) << "scan " << scan;
    });
  }
  EXPECT_LT(most_open, plain.voxel_count() / 2);
  if (memory_m > 0) {
    EXPECT_LT(rolling.voxel_count(), plain.voxel_count());
  } else {
    EXPECT_EQ(rolling.voxel_count(), plain.voxel_count());
  }
}

TEST(RollingMap, LosesNothingWhenFarTilesArePacked) {
  expect_nothing_is_lost(0, nullptr);
}

TEST(RollingMap, LosesNothingWhenFarTilesAreStored) {
  TilesInATable store;
  expect_nothing_is_lost(50, &store);
  EXPECT_GT(store.keys().size(), 5u);
}

TEST(RollingMap, WithoutAStoreWhatIsFarIsForgotten) {
  VoxelMap map(0.1);
  RollingMap rolling(map, 20, 30);
  visit(rolling, {0, 0, 0}, 1);
  hit(map, {0, 0, 0}, 5, 1, 1.0F);
  for (std::uint32_t scan = 2; scan < 40; ++scan) visit(rolling, {500, 0, 0}, scan);
  EXPECT_EQ(rolling.voxel_count(), 0u);
  visit(rolling, {0, 0, 0}, 50);
  EXPECT_EQ(map.find_block({0, 0, 0}), -1);
}

TEST(RollingMap, ImportsIntoOpenAndClosedTiles) {
  VoxelMap map(0.1), other(0.1);
  RollingMap rolling(map, 20, 0);
  visit(rolling, {0, 0, 0}, 1);
  hit(map, {0, 0, 0}, 5, 1, 1.0F);
  hit(map, {1, 0, 0}, 5, 1, 1.0F);
  for (const int x : {0, 500, 501}) hit(other, {x, 0, 0}, 9, 1, -2.0F);
  const auto contents = [&](int x) { return other.block(other.find_block({x, 0, 0})).contents(1); };
  rolling.import({contents(0), contents(500)}, 1);
  rolling.import({contents(501)}, 1);
  EXPECT_EQ(rolling.voxel_count(), 4u);
  EXPECT_EQ(map.find({5, 0, 0}), nullptr);  // replaced
  EXPECT_NE(map.find({8 + 5, 0, 0}), nullptr);
  visit(rolling, {401, 0, 0}, 2);
  EXPECT_EQ(map.find(voxel_key(BlockKey(500, 0, 0), 9))->log_odds(), -2.0F);
  EXPECT_EQ(map.find(voxel_key(BlockKey(501, 0, 0), 9))->log_odds(), -2.0F);
}

TEST(RollingMap, EditsOpenPackedAndStoredTiles) {
  VoxelMap map(0.1);
  RollingMap rolling(map, 20, 60);
  TilesInATable store;
  rolling.set_store(&store);
  visit(rolling, {0, 0, 0}, 1);
  hit(map, {0, 0, 0}, 5, 1, 1.0F);
  for (std::uint32_t scan = 2; scan < 40; ++scan) visit(rolling, {100, 0, 0}, scan);
  hit(map, {125, 0, 0}, 5, 39, 1.0F);
  for (std::uint32_t scan = 40; scan < 80; ++scan) visit(rolling, {140, 0, 0}, scan);
  hit(map, {175, 0, 0}, 5, 79, 1.0F);
  ASSERT_EQ(map.voxel_count(), 1u);
  ASSERT_EQ(rolling.voxel_count(), 2u);
  ASSERT_EQ(store.keys().size(), 1u);

  const auto log_odds_at = [&](int x) {
    return VoxelReader(rolling, 80).find({8 * x + 5, 0, 0})->log_odds();
  };
  const auto negate = [](BlockContents& block) {
    for (Voxel& voxel : block.voxels) voxel.set_log_odds(-voxel.log_odds());
    return true;
  };
  rolling.edit({Eigen::Vector3d(-500, 200, 0), Eigen::Vector3d(500, 201, 1)}, 80, negate);
  for (const int x : {0, 125, 175}) EXPECT_EQ(log_odds_at(x), 1.0F) << x;
  rolling.edit({Eigen::Vector3d(-500, 0, 0), Eigen::Vector3d(500, 1, 1)}, 80, negate);
  for (const int x : {0, 125, 175}) EXPECT_EQ(log_odds_at(x), -1.0F) << x;
  EXPECT_EQ(rolling.voxel_count(), 2u);
  EXPECT_EQ(VoxelReader(rolling, 80).find({5, 0, 0})->idle, 79);
  EXPECT_FALSE(VoxelReader(rolling, 80).find({6, 0, 0}));
}

TEST(RollingMap, APlaceThatNoVoxelCanHaveOpensNothing) {
  VoxelMap map(0.1);
  RollingMap rolling(map, 20, 0);
  visit(rolling, {1e15, 0, 0}, 1);
  EXPECT_TRUE(rolling.tiles().empty());
}

TEST(TilePacking, RefusesWhatItDidNotPack) {
  EXPECT_TRUE(unpack(pack({})).empty());
  expect_error([] { unpack("no such thing"); }, {"damaged"});
  const std::string packed = pack({BlockContents{}});
  expect_error([&] { unpack(packed.substr(0, packed.size() - 1)); }, {"damaged"});
}

/// There and back again through a street, seen 20 m far.
std::vector<Frame> there_and_back() {
  SimulationOptions options;
  options.scene = "street";
  options.sensor = "vlp16";
  options.ego_speed_mps = 30;
  options.scans = 40;
  std::vector<Frame> frames = Simulator(options).frames();
  for (std::size_t k = options.scans; k-- > 0;) frames.push_back(frames[k]);
  return frames;
}

TEST(RollingMap, TheLabelsDoNotDependOnIt) {
  const std::vector<Frame> frames = there_and_back();
  Parameters p;
  p.max_range_m = 20;
  Mapper all(p);
  p.rolling_radius_m = 20;
  Mapper rolling(p);
  TilesInATable store;
  rolling.set_tile_store(&store);
  std::size_t stored = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const ScanLabels a = all.process(frames[k].scan, frames[k].T_map_sensor);
    const ScanLabels& b = rolling.process(frames[k].scan, frames[k].T_map_sensor);
    ASSERT_EQ(a.label, b.label) << "scan " << k;
    ASSERT_EQ(a.reason, b.reason) << "scan " << k;
    ASSERT_EQ(a.p_static, b.p_static) << "scan " << k;
    stored = std::max(stored, store.keys().size());
  }
  EXPECT_GT(stored, 10u);
  EXPECT_LT(rolling.voxel_count(), all.voxel_count());
  for (std::size_t k = 0; k < frames.size(); k += 20) {
    const std::size_t rows = frames[k].scan.points.size();
    const ScanLabels open{std::vector<Label>(rows, Label::kUncertain), std::vector<float>(rows, 0.5F),
                          std::vector<Reason>(rows, Reason::kNeverJudged),
                          std::vector<std::int32_t>(rows, kNoObject)};
    const ScanLabels a = all.relabel(frames[k].scan, frames[k].T_map_sensor, open);
    EXPECT_EQ(a.label, rolling.relabel(frames[k].scan, frames[k].T_map_sensor, open).label);
    EXPECT_GT(count(a).is_static, rows / 2);
  }
  rolling.reset();
  EXPECT_TRUE(store.keys().empty());
}

}  // namespace
}  // namespace stillmap
