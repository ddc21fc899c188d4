// A disk that is full: what was there stays, the message says so, and nothing is left lying about. A limit on
// the size of files is a full disk for the process that has it.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "io/map_archive.hpp"
#include "io/map_file.hpp"
#include "io/tile_folder.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

/// No file may grow beyond it for as long as this lives.
class FileLimit {
 public:
  explicit FileLimit(std::uintmax_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);  // as on a full disk, writing fails
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

MapContents large_map() {
  MapContents map{7, 0.25, {}};
  for (int b = 0; b < 40; ++b) {
    BlockContents& block = map.blocks.emplace_back();
    block.key = BlockKey(b, 0, 0);
    block.occupied.fill(~std::uint64_t{0});
    block.voxels.resize(kBlockVolume);
    for (std::size_t v = 0; v < block.voxels.size(); ++v)
      block.voxels[v].set_log_odds(v % 3 == 0 ? -2.0F : 2.0F);  // octrees cannot merge them
  }
  return map;
}

std::size_t entries(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

class FullDisk : public testing::TestWithParam<const char*> {};

TEST_P(FullDisk, KeepsTheMapThatWasThere) {
  const TemporaryFolder folder;
  const std::string name = std::string("map.") + GetParam(), path = folder.path(name);
  const MapContents map = large_map();
  const Decision decision{0.7F, 0.3F};
  save_map(pieces_of(map), decision, path);
  const std::uintmax_t whole = fs::file_size(path);
  folder.write(name, "the map of yesterday");
  for (const std::uintmax_t bytes : {std::uintmax_t{0}, whole / 3, whole - 1}) {
    const FileLimit limit(bytes);
    expect_error([&] { save_map(pieces_of(map), decision, path); }, {path, "cannot be written"});
    EXPECT_TRUE(read_text(path) == "the map of yesterday") << bytes << " of " << whole << " bytes";
    EXPECT_EQ(entries(folder), 1u);
  }
  const FileLimit limit(whole);
  save_map(pieces_of(map), decision, path);
  EXPECT_EQ(fs::file_size(path), whole);
}

INSTANTIATE_TEST_SUITE_P(EachFormat, FullDisk, testing::Values("stillmap", "pcd", "ply", "bt", "ot"),
                         [](const auto& info) { return std::string(info.param); });

TEST(ReadOnlyPlace, IsNamed) {  // /proc is one for everybody, root too
  for (const char* path : {"/proc/map.stillmap", "/proc/map.pcd", "/proc/map.bt"})
    expect_error([&] { save_map(pieces_of(large_map()), {0.7F, 0.3F}, path); }, {path, "cannot be written"});
  expect_error([] { TileFolder("/proc/far", 0.1, 1000, [](const std::string&) {}); }, {"/proc/far"});
}

TEST(FullDisk, TilesThatAreLostAreToldAndLaterOnesAreKept) {
  const TemporaryFolder folder;
  std::vector<std::string> said;
  TileFolder tiles(folder.path(), 0.1, 1'000'000'000, [&](const std::string& text) { said.push_back(text); });
  {
    const FileLimit limit(1000);
    tiles.put({0, 0}, {1, large_map().blocks});
    tiles.wait_until_written();
    EXPECT_TRUE(tiles.get({0, 0}).blocks.empty());
  }
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("far tiles are lost"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("0_0.stillmap: cannot be written"), std::string::npos) << said[0];
  tiles.put({1, 0}, {1, large_map().blocks});
  tiles.wait_until_written();
  EXPECT_EQ(tiles.get({1, 0}).blocks.size(), 40u);
}

}  // namespace
}  // namespace stillmap
