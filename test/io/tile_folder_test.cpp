#include "io/tile_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <set>

#include "io/map_archive.hpp"
#include "io/whole_map.hpp"
#include "simulation/simulator.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

constexpr double kVoxel_m = 0.1;
constexpr std::uintmax_t kMuch = 1000000000;

void fail(const std::string& message) {
  ADD_FAILURE() << message;
}

/// `blocks` blocks of one voxel in the tile; all hits are `mark`.
Tile marked(const TileKey& key, std::uint32_t scan, int blocks, int mark) {
  Tile tile{scan, {}};
  for (int b = 0; b < blocks; ++b) {
    BlockContents& block = tile.blocks.emplace_back();
    block.key = BlockKey(key.x() * kTileEdge, key.y() * kTileEdge, b);
    block.occupied[0] = 1;
    block.voxels.resize(1);
    block.voxels[0].hits = static_cast<std::uint8_t>(mark);
  }
  return tile;
}

std::size_t tile_files(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.path().extension() == ".stillmap";
  return count;
}

TEST(TileFolder, GivesBackTheNewestOfEachTile) {
  const TemporaryFolder folder;
  TileFolder tiles(folder.path("far"), kVoxel_m, kMuch, fail);
  for (int round = 1; round <= 3; ++round)
    for (int x = -20; x < 20; ++x) tiles.put({x, -x}, marked({x, -x}, 10 * round + 1, 3, round));
  for (const bool written : {false, true}) {
    if (written) tiles.wait_until_written();
    for (int x = -20; x < 20; ++x) {
      const Tile tile = tiles.get({x, -x});
      EXPECT_EQ(tile.scan, 31u);
      ASSERT_EQ(tile.blocks.size(), 3u);
      EXPECT_EQ(tile.blocks[2].key, BlockKey(16 * x, -16 * x, 2));
      EXPECT_EQ(tile.blocks[2].voxels[0].hits, 3);
    }
    EXPECT_EQ(tiles.keys().size(), 40u);
  }
  EXPECT_TRUE(tiles.get({5, 5}).blocks.empty());
  EXPECT_EQ(tile_files(folder.path()), 40u);
  EXPECT_EQ(read_map_archive(tiles.run_folder()).blocks.size(), 120u);
  tiles.clear();
  EXPECT_TRUE(tiles.keys().empty());
  EXPECT_EQ(tile_files(folder.path()), 0u);
}

TEST(TileFolder, TheOldestLeavesFirstAndIsToldOnce) {
  const TemporaryFolder folder;
  std::vector<std::string> said;
  const auto say = [&](const std::string& message) { said.push_back(message); };
  { TileFolder(folder.path(), kVoxel_m, kMuch, say).put({7, 7}, marked({7, 7}, 1, 100, 1)); }
  EXPECT_EQ(tile_files(folder.path()), 1u);
  TileFolder tiles(folder.path(), kVoxel_m, 50000, say);  // 100 blocks take 9.3 kB
  EXPECT_EQ(fs::path(tiles.run_folder()).filename(), "run_000002");
  EXPECT_TRUE(tiles.get({7, 7}).blocks.empty());  // another run's
  for (int x = 0; x < 5; ++x) {
    tiles.put({x, 0}, marked({x, 0}, 2, 100, 1));
    tiles.wait_until_written();
  }
  EXPECT_FALSE(fs::exists(folder.path("run_000001")));
  EXPECT_EQ(tiles.keys().size(), 5u);
  tiles.put({0, 0}, marked({0, 0}, 3, 100, 2));  // now the newest
  tiles.wait_until_written();
  tiles.put({9, 0}, marked({9, 0}, 3, 100, 1));
  tiles.wait_until_written();
  EXPECT_TRUE(tiles.get({1, 0}).blocks.empty());
  EXPECT_FALSE(tiles.get({0, 0}).blocks.empty());
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("rolling_disk_mb"), std::string::npos);
}

TEST(TileFolder, ADamagedTileIsLostAndTold) {
  const TemporaryFolder folder;
  std::vector<std::string> said;
  TileFolder tiles(folder.path(), kVoxel_m, kMuch, [&](const std::string& text) { said.push_back(text); });
  for (int x = 0; x < 2; ++x) tiles.put({x, 0}, marked({x, 0}, 1, 1, 1));
  tiles.wait_until_written();
  std::ofstream(tiles.run_folder() + "/1_0.stillmap") << "not a tile";
  EXPECT_TRUE(tiles.get({1, 0}).blocks.empty());
  EXPECT_EQ(tiles.get({0, 0}).blocks.size(), 1u);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("1_0.stillmap: not a .stillmap file"), std::string::npos) << said[0];
}

TEST(TileFolder, AFolderHasOneUserAndMustBeWritable) {
  const TemporaryFolder folder;
  const TileFolder tiles(folder.path(), kVoxel_m, kMuch, fail);
  expect_error([&] { TileFolder(folder.path(), kVoxel_m, kMuch, fail); }, {"another stillmap"});
  expect_error([&] { TileFolder(folder.write("file", "") + "/x", kVoxel_m, kMuch, fail); },
               {"cannot be made"});
}

TEST(TileFolder, WhateverEndsTheProcessLeavesWholeTiles) {
  const TemporaryFolder folder;
  constexpr int kRuns = 8;
  for (int run = 1; run <= kRuns; ++run) {
    const pid_t child = fork();
    if (child == 0) {
      TileFolder tiles(folder.path(), kVoxel_m, kMuch, [](const std::string&) { _exit(1); });
      for (std::uint32_t scan = 1;; ++scan)
        tiles.put({static_cast<int>(scan % 3), 0}, marked({static_cast<int>(scan % 3), 0}, scan, 2000, 5));
    }
    const fs::path first = folder.path("run_00000" + std::to_string(run) + "/1_0.stillmap");
    for (int i = 0; i < 3000 && !fs::exists(first); ++i) usleep(10000);
    usleep(static_cast<useconds_t>(run) * 700);  // at another moment of the writing each time
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  std::size_t whole = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".stillmap" || name.front() == '.') continue;
    EXPECT_EQ(read_map_archive(entry.path().string()).blocks.size(), 2000u);
    ++whole;
  }
  EXPECT_GE(whole, static_cast<std::size_t>(kRuns));
  TileFolder(folder.path(), kVoxel_m, kMuch, fail);  // half written ones are swept away
  EXPECT_EQ(tile_files(folder.path()), whole);
}

TEST(TileFolder, TheWholeMapIsWhatIsNearAndWhatIsFar) {
  SimulationOptions options;
  options.scene = "street";
  options.sensor = "vlp16";
  options.ego_speed_mps = 30;
  options.scans = 30;
  const Simulator simulator(options);
  const TemporaryFolder folder;
  Parameters p;
  p.max_range_m = 20;
  Mapper all(p);
  p.rolling_radius_m = 20;
  p.rolling_directory = folder.path("far");
  const auto tiles = open_tile_folder(p, fail);
  Mapper rolling(p);
  rolling.set_tile_store(tiles.get());
  for (std::size_t k = 0; k < options.scans; ++k) {
    const Frame frame = simulator.frame(k).frame;
    all.process(frame.scan, frame.T_map_sensor);
    rolling.process(frame.scan, frame.T_map_sensor);
  }
  std::mutex mutex;
  write_map_archive(whole_map(all, nullptr, mutex), folder.path("a.stillmap"));
  write_map_archive(whole_map(rolling, tiles.get(), mutex), folder.path("b.stillmap"));
  EXPECT_LT(rolling.voxel_count(), all.voxel_count());
  const MapContents a = read_map_archive(folder.path("a.stillmap"));
  const MapContents b = read_map_archive(folder.path("b.stillmap"));
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  const auto voxels_of = [](const MapContents& map) {
    std::set<std::pair<std::uint64_t, std::string>> voxels;
    for (const BlockContents& block : map.blocks)
      voxels.insert({packed(block.key), std::string(reinterpret_cast<const char*>(block.voxels.data()),
                                                    block.voxels.size() * sizeof(Voxel))});
    return voxels;
  };
  EXPECT_EQ(voxels_of(a), voxels_of(b));
}

TEST(TileFolder, IsOpenedWhenTheParametersAskForIt) {
  std::vector<std::string> said;
  const auto say = [&](const std::string& message) { said.push_back(message); };
  Parameters p;
  EXPECT_EQ(open_tile_folder(p, say), nullptr);
  EXPECT_TRUE(said.empty());
  p.rolling_radius_m = 200;
  EXPECT_EQ(open_tile_folder(p, say), nullptr);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("rolling_directory is empty"), std::string::npos);
}

}  // namespace
}  // namespace stillmap
