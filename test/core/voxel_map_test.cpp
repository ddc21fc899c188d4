// The hashed blocks against std::map.
#include "stillmap/voxel_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace stillmap {
namespace {

using PlainMap = std::map<std::tuple<int, int, int>, int>;

Voxel& find_or_create(VoxelMap& map, const VoxelKey& key, bool& created) {
  Voxel& voxel =
      map.block(map.find_or_create_block(block_key(key))).find_or_create(place_in_block(key), created);
  map.count_created(created);
  return voxel;
}

/// Random keys, near each other so that blocks fill up, on both sides of zero.
VoxelKey some_key(std::mt19937& random) {
  std::uniform_int_distribution<int> near(-20, 20);
  return {near(random), near(random), near(random)};
}

TEST(VoxelMap, HoldsWhatAPlainMapHolds) {
  VoxelMap map(0.1);
  PlainMap plain;
  std::mt19937 random(4);
  for (int i = 0; i < 20000; ++i) {
    const VoxelKey key = some_key(random);
    bool created = false;
    Voxel& voxel = find_or_create(map, key, created);
    EXPECT_EQ(created, plain.count({key.x(), key.y(), key.z()}) == 0);
    voxel.log_odds_fixed = static_cast<std::int16_t>(i);
    plain[{key.x(), key.y(), key.z()}] = static_cast<std::int16_t>(i);
  }
  EXPECT_EQ(map.voxel_count(), plain.size());
  for (int i = 0; i < 20000; ++i) {
    const VoxelKey key = some_key(random);
    const auto expected = plain.find({key.x(), key.y(), key.z()});
    const Voxel* found = map.find(key);
    ASSERT_EQ(found != nullptr, expected != plain.end());
    if (found != nullptr) {
      EXPECT_EQ(found->log_odds_fixed, expected->second);
    }
  }
}

TEST(VoxelMap, BlocksVisitTheirVoxelsByAscendingPlace) {
  VoxelMap map(0.1);
  std::mt19937 random(5);
  std::size_t stored = 0;
  for (int i = 0; i < 3000; ++i) {
    bool created = false;
    const VoxelKey key = some_key(random);
    find_or_create(map, key, created).log_odds_fixed = static_cast<std::int16_t>(place_in_block(key));
    stored += created;
  }
  std::size_t visited = 0;
  for (std::uint32_t index = 0; index < map.block_count(); ++index) {
    int last = -1;
    map.block(index).for_each([&](int place, const Voxel& voxel) {
      EXPECT_GT(place, last);
      EXPECT_EQ(voxel.log_odds_fixed, place);
      last = place;
      ++visited;
    });
  }
  EXPECT_EQ(visited, stored);
}

TEST(VoxelMap, BlocksKeepTheirIndexAndAddress) {
  VoxelMap map(0.1);
  const std::uint32_t first = map.find_or_create_block({3, -2, 1});
  const VoxelBlock* address = &map.block(first);
  for (int x = 0; x < 2000; ++x) map.find_or_create_block({x, 0, 7});
  EXPECT_EQ(map.find_or_create_block({3, -2, 1}), first);
  EXPECT_EQ(&map.block(first), address);
  EXPECT_EQ(map.find_block({0, 0, 999}), -1);
}

TEST(VoxelMap, AnErasedTileIsGoneAndItsIndicesAreUsedAgain) {
  VoxelMap map(0.1);
  std::vector<std::uint32_t> gone;
  bool created = false;
  for (int x = -kTileEdge; x < kTileEdge; ++x) {  // two tiles
    const std::uint32_t index = map.find_or_create_block({x, 3, x});
    map.block(index).find_or_create(x & 63, created).hit(Eigen::Vector3f::Zero());
    map.count_created(created);
    map.block(index).hit_scan = 5;
    if (x < 0) gone.push_back(index);
  }
  map.erase_tile({-1, 0});
  map.erase_tile({-1, 0});
  map.erase_tile({7, 7});
  EXPECT_EQ(map.tile({-1, 0}), nullptr);
  EXPECT_EQ(map.voxel_count(), static_cast<std::size_t>(kTileEdge));
  const std::size_t indices = map.block_count();
  for (int x = -kTileEdge; x < kTileEdge; ++x) EXPECT_EQ(map.find_block({x, 3, x}) < 0, x < 0);
  for (int x = 0; x < kTileEdge; ++x) {
    const std::uint32_t index = map.find_or_create_block({x, 200, 0});
    EXPECT_EQ(std::count(gone.begin(), gone.end(), index), 1);
    EXPECT_EQ(map.block(index).size(), 0u);
    EXPECT_EQ(map.block(index).hit_scan, 0u);
    EXPECT_EQ(map.block(index).key(), BlockKey(x, 200, 0));
  }
  EXPECT_EQ(map.block_count(), indices);
  map.find_or_create_block({0, 400, 0});
  EXPECT_EQ(map.block_count(), indices + 1);
}

TEST(VoxelMap, FindsAllThatIsNearAndLittleElse) {
  VoxelMap map(0.1);
  std::mt19937 random(6);
  std::uniform_int_distribution<int> anywhere(-300, 300);
  for (int i = 0; i < 5000; ++i) map.find_or_create_block({anywhere(random), anywhere(random), i % 40});
  const double reach_m = 50, tile_m = kTileEdge * map.block_size_m();
  const Eigen::Vector3d center(-20.03, 33.3, 1);
  std::vector<const BlockTile*> tiles;
  map.find_near(center, reach_m, tiles);
  std::set<std::uint32_t> near;
  for (const BlockTile* tile : tiles)
    for (const BlockEntry& entry : *tile) {
      EXPECT_TRUE(near.insert(entry.index).second);
      EXPECT_EQ(entry.key, map.block(entry.index).key());
    }
  for (std::uint32_t index = 0; index < map.block_count(); ++index) {
    const Eigen::Vector2d corner = map.block(index).key().head<2>().cast<double>() * map.block_size_m();
    const double distance_m = (corner - center.head<2>()).norm();
    if (distance_m <= reach_m) {
      EXPECT_EQ(near.count(index), 1u);
    }
    if (distance_m > reach_m + tile_m * std::sqrt(2.0)) {
      EXPECT_EQ(near.count(index), 0u);
    }
  }
}

TEST(VoxelMap, CentreOfAVoxelLiesInIt) {
  const VoxelMap map(0.25);
  EXPECT_TRUE(map.center_of({0, -1, 8}).isApprox(Eigen::Vector3d(0.125, -0.125, 2.125)));
  EXPECT_EQ(map.key_of(map.center_of({5, -7, 0})), VoxelKey(5, -7, 0));
}

TEST(VoxelMap, BlocksStayWhereTheyAre) {
  VoxelMap map(0.1);
  const VoxelBlock* const first = &map.block(map.find_or_create_block({0, 0, 0}));
  for (int x = 1; x < 5000; ++x) map.find_or_create_block({x, 0, 0});
  EXPECT_EQ(&map.block(map.find_or_create_block({0, 0, 0})), first);
  EXPECT_EQ(map.block_count(), 5000u);
  for (int x = 0; x < 5000; ++x) ASSERT_EQ(map.block(map.find_or_create_block({x, 0, 0})).key().x(), x);
}

TEST(VoxelBlock, ManyVoxelsAtOnceAreAsOneByOne) {
  std::mt19937 random(6);
  for (int round = 0; round < 20; ++round) {
    VoxelBlock at_once({0, 0, 0}), one_by_one({0, 0, 0});
    for (int more = 0; more < 6; ++more) {
      PlaceMask places{};
      for (int i = 0; i < 1 << more * 2; ++i)
        places[random() % places.size()] |= std::uint64_t{1} << random() % 64;
      const PlaceMask made = at_once.create(places);
      for (int place = 0; place < kBlockVolume; ++place) {
        const std::uint64_t bit = std::uint64_t{1} << (place & 63);
        bool created = false;
        if ((places[place >> 6] & bit) != 0) one_by_one.find_or_create(place, created);
        ASSERT_EQ((made[place >> 6] & bit) != 0, created);
        if (!created) continue;
        EXPECT_EQ(at_once.at(place).hits, 0);
        at_once.at(place).log_odds_fixed = one_by_one.at(place).log_odds_fixed =
            static_cast<std::int16_t>(1000 * more + place);
      }
      ASSERT_EQ(at_once.size(), one_by_one.size());
      one_by_one.for_each([&](int place, const Voxel& voxel) {
        ASSERT_TRUE(at_once.contains(place));
        ASSERT_EQ(at_once.at(place).log_odds_fixed, voxel.log_odds_fixed);
      });
    }
  }
}

TEST(VoxelBlock, AgesByTheScansThatPassed) {
  VoxelBlock block({0, 0, 0});
  block.age(10);
  bool created = false;
  block.find_or_create(100, created).hit(Eigen::Vector3f::Zero());
  block.age(10);
  EXPECT_EQ(block.at(100).idle, 0);
  block.age(13);
  EXPECT_EQ(block.at(100).idle, 3);
  EXPECT_EQ(block.at(100).age, 3);
  block.at(100).hit(Eigen::Vector3f::Zero());
  block.age(14);
  EXPECT_EQ(block.at(100).idle, 1);
  EXPECT_EQ(block.at(100).age, 4);
  block.age(1000000);
  EXPECT_EQ(block.at(100).idle, 255);
  EXPECT_EQ(block.at(100).age, 255);
}

}  // namespace
}  // namespace stillmap
