// kill -9 at any moment of writing a map or a tile: what is on disk opens, and is at least as new as what was
// acknowledged. STILLMAP_KILLS says how often, scripts/kill_test.sh runs it for long.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>

#include "io/map_archive.hpp"
#include "io/tile_folder.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

constexpr int kBlocks = 400;

int kills() {
  const char* const given = std::getenv("STILLMAP_KILLS");
  return given != nullptr ? std::atoi(given) : 20;
}

/// Each block says how many saves there were before.
std::vector<BlockContents> blocks_of(std::uint64_t number) {
  std::vector<BlockContents> blocks(kBlocks);
  for (int b = 0; b < kBlocks; ++b) {
    blocks[b].key = BlockKey(b % kTileEdge, 0, b);
    blocks[b].porous = number;
    blocks[b].occupied.fill(~std::uint64_t{0});
    blocks[b].voxels.resize(kBlockVolume);
  }
  return blocks;
}

/// Runs `save` with 1, 2, 3 ... in a process of its own and kills it some time after the first; the number of
/// the last save that came back.
std::uint64_t last_acknowledged(const std::function<void(std::uint64_t)>& save, int wait_us) {
  int channel[2];
  EXPECT_EQ(pipe(channel), 0);
  const pid_t child = fork();
  if (child == 0) {
    for (std::uint64_t number = 1;; ++number) {
      save(number);
      if (write(channel[1], &number, sizeof(number)) != sizeof(number)) _exit(1);
    }
  }
  close(channel[1]);
  std::uint64_t number = 0, last = 0;
  EXPECT_EQ(read(channel[0], &last, sizeof(last)), static_cast<ssize_t>(sizeof(last)));
  usleep(static_cast<useconds_t>(wait_us));
  kill(child, SIGKILL);
  while (read(channel[0], &number, sizeof(number)) == sizeof(number)) last = number;
  close(channel[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  return last;
}

void expect_whole(const std::vector<BlockContents>& blocks, std::uint64_t at_least) {
  ASSERT_EQ(blocks.size(), static_cast<std::size_t>(kBlocks));
  EXPECT_GE(blocks.front().porous, at_least);
  EXPECT_LE(blocks.front().porous, at_least + 1);
  for (const BlockContents& block : blocks) ASSERT_EQ(block.porous, blocks.front().porous);
}

TEST(Kill, ASavedMapIsWholeAndNotOlderThanWhatWasAcknowledged) {
  const TemporaryFolder folder;
  const std::string path = folder.path("map.stillmap");
  std::minstd_rand random(1);
  for (int k = 0; k < kills(); ++k) {
    const auto save = [&](std::uint64_t number) {
      const MapContents map{static_cast<std::int64_t>(number), 0.1, blocks_of(number)};
      write_map_archive(pieces_of(map), path);
    };
    const std::uint64_t last = last_acknowledged(save, static_cast<int>(random() % 60000));
    expect_whole(read_map_archive(path).blocks, last);
  }
}

TEST(Kill, ATileIsWholeAndNotOlderThanWhatWasAcknowledged) {
  std::minstd_rand random(2);
  for (int k = 0; k < kills(); ++k) {
    const TemporaryFolder folder;
    const auto most_bytes = std::uintmax_t{1} << 30;
    std::unique_ptr<TileFolder> tiles;  // only the child has one: its thread would not outlive the fork
    const auto save = [&](std::uint64_t number) {
      if (!tiles)
        tiles = std::make_unique<TileFolder>(folder.path(), 0.1, most_bytes,
                                             [](const std::string&) { _exit(1); });
      tiles->put({0, 0}, {0, blocks_of(number)});
      tiles->wait_until_written();
    };
    const std::uint64_t last = last_acknowledged(save, static_cast<int>(random() % 60000));
    expect_whole(read_map_archive(folder.path("run_000001/0_0.stillmap")).blocks, last);
  }
}

}  // namespace
}  // namespace stillmap
