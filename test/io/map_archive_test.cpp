#include "io/map_archive.hpp"

#include <gtest/gtest.h>

#include <random>

#include "io/map_archive_format.hpp"
#include "io/map_file.hpp"
#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

constexpr double kVoxel_m = 0.25;

void add_voxel(BlockContents& block, int place, Voxel voxel) {
  block.occupied[place >> 6] |= std::uint64_t{1} << (place & 63);
  block.voxels.push_back(voxel);
}

Voxel some_voxel(std::mt19937& random) {
  Voxel voxel;
  voxel.log_odds_fixed = static_cast<std::int16_t>(random());
  voxel.surface = static_cast<std::uint16_t>(random());
  voxel.hits = static_cast<std::uint8_t>(random());
  voxel.idle = static_cast<std::uint8_t>(random());
  voxel.age = static_cast<std::uint8_t>(random());
  voxel.seen_through = random() & 0x3F;
  voxel.moved_in = random() & 1;
  voxel.came_back = random() & 1;
  return voxel;
}

MapContents random_map(int blocks, int voxels_each) {
  std::mt19937 random(7);
  MapContents map{-123'456'789'012'345, kVoxel_m, {}};
  for (int b = 0; b < blocks; ++b) {
    BlockContents& block = map.blocks.emplace_back();
    block.key = BlockKey(b - blocks / 2, -3 * b, (1 << 20) - 1 - b);
    block.porous = random();
    for (int v = 0; v < voxels_each; ++v)
      add_voxel(block, v * kBlockVolume / voxels_each, some_voxel(random));
  }
  return map;
}

std::string bytes_of(const BlockContents& block) {
  std::string bytes;
  map_archive::encode(block, bytes);
  return bytes;
}

void expect_equal(const MapContents& a, const MapContents& b) {
  EXPECT_EQ(a.stamp_ns, b.stamp_ns);
  EXPECT_EQ(a.voxel_size_m, b.voxel_size_m);
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].key, b.blocks[i].key);
    EXPECT_EQ(bytes_of(a.blocks[i]), bytes_of(b.blocks[i]));
  }
}

TEST(MapArchive, GivesBackEveryBitOfEveryVoxel) {
  const TemporaryFolder folder;
  for (const MapContents& map : {random_map(0, 0), random_map(1, 1), random_map(900, 512)}) {
    write_map_archive(pieces_of(map), folder.path("a.stillmap"));
    const MapContents read = read_map_archive(folder.path("a.stillmap"));
    expect_equal(read, map);
    for (std::size_t b = 0; b < map.blocks.size(); ++b)
      for (std::size_t v = 0; v < map.blocks[b].voxels.size(); ++v)
        ASSERT_EQ(std::memcmp(&read.blocks[b].voxels[v], &map.blocks[b].voxels[v], sizeof(Voxel)), 0);
  }
}

TEST(MapArchive, IsLittleEndianOnEveryMachine) {
  const TemporaryFolder folder;
  MapContents map{0x0102030405060708, kVoxel_m, {}};
  BlockContents& block = map.blocks.emplace_back();
  block.key = BlockKey(-2, 1, 0);
  Voxel voxel;
  voxel.log_odds_fixed = -2;
  voxel.surface = 0x1234;
  voxel.hits = 3;
  voxel.idle = 4;
  voxel.age = 5;
  voxel.seen_through = 6;
  voxel.came_back = 1;
  add_voxel(block, 511, voxel);
  write_map_archive(pieces_of(map), folder.path("a.stillmap"));
  const std::string file = read_text(folder.path("a.stillmap"));
  EXPECT_EQ(file.substr(0, 12), std::string("STILLMAP\2\0\0\0", 12));
  EXPECT_EQ(file.substr(20, 8), "\x08\x07\x06\x05\x04\x03\x02\x01");
  EXPECT_EQ(file.substr(32, 8), std::string("\1\0\0\0\x5C\0\0\0", 8));  // 1 block in 92 bytes
  EXPECT_EQ(file.substr(44, 12), std::string("\xFE\xFF\xFF\xFF\1\0\0\0\0\0\0\0", 12));
  EXPECT_EQ(file.substr(128, 8), "\xFE\xFF\x34\x12\x03\x04\x05\x86");
}

TEST(MapArchive, RefusesEveryTruncation) {
  const TemporaryFolder folder;
  write_map_archive(pieces_of(random_map(2, 5)), folder.path("a.stillmap"));
  const std::string whole = read_text(folder.path("a.stillmap"));
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes)
    expect_error([&] { read_map_archive(folder.write("b.stillmap", whole.substr(0, bytes))); },
                 {"b.stillmap", bytes < 8 ? "not a .stillmap file" : "cut off"});
}

TEST(MapArchive, RefusesEveryFlippedBitAndWhatFollowsTheEnd) {
  const TemporaryFolder folder;
  write_map_archive(pieces_of(random_map(2, 3)), folder.path("a.stillmap"));
  const std::string whole = read_text(folder.path("a.stillmap"));
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    expect_error([&] { read_map_archive(folder.write("b.stillmap", damaged)); }, {"b.stillmap"});
  }
  expect_error([&] { read_map_archive(folder.write("b.stillmap", whole + '\0')); }, {"damaged", "end"});
}

TEST(MapArchive, RefusesCountsBeforeItMakesRoomForThem) {
  const TemporaryFolder folder;
  write_map_archive(pieces_of(random_map(1, 1)), folder.path("a.stillmap"));
  const std::string whole = read_text(folder.path("a.stillmap"));
  for (const std::size_t at : {32u, 36u}) {  // the section's blocks and its bytes
    std::string damaged = whole;
    damaged.replace(at, 4, "\xFF\xFF\xFF\xFF");
    expect_error([&] { read_map_archive(folder.write("b.stillmap", damaged)); }, {"4294967295", "cannot be"});
  }
}

TEST(MapArchive, RefusesForeignFilesAndOtherVersions) {
  const TemporaryFolder folder;
  for (const std::string text : {"", "VERSION 0.7\nFIELDS x y z\n", "stillmap as it is not written"})
    expect_error([&] { read_map_archive(folder.write("b.stillmap", text)); }, {"not a .stillmap file"});
  expect_error([&] { read_map_archive(folder.path("none.stillmap")); }, {"none.stillmap", "No such file"});
  write_map_archive(pieces_of(random_map(1, 1)), folder.path("a.stillmap"));
  std::string other = read_text(folder.path("a.stillmap"));
  other[8] = 9;
  expect_error([&] { read_map_archive(folder.write("b.stillmap", other)); }, {"format 9", "format 2"});
}

Mapper drive(std::size_t scans, Mapper mapper = Mapper(preset("default")), std::size_t from = 0) {
  SimulationOptions options;
  options.scene = "plaza";
  options.sensor = "vlp16";
  options.scans = 12;
  const Simulator simulator(options);
  for (std::size_t k = from; k < scans; ++k) {
    const Frame frame = simulator.frame(k).frame;
    mapper.process(frame.scan, frame.T_map_sensor);
  }
  return mapper;
}

TEST(MapArchive, AMapperGetsItsMapBack) {
  const TemporaryFolder folder;
  const Mapper mapper = drive(8);
  save_map(pieces_of(mapper.export_map()), mapper.decision(), folder.path("map.stillmap"));
  Mapper again(preset("default"));
  again.import_map(read_map_archive(folder.path("map.stillmap")));
  expect_equal(again.export_map(), mapper.export_map());
  EXPECT_EQ(again.voxel_count(), mapper.voxel_count());
  // and it is a map to go on with: a second drive meets what it knows
  const Mapper fresh = drive(12, Mapper(preset("default")), 8), more = drive(12, std::move(again), 8);
  EXPECT_GT(more.voxel_count(), mapper.voxel_count());
  EXPECT_GT(more.voxel_count(), fresh.voxel_count());
}

TEST(MapArchive, TheSnapshotOfTheContentsIsTheMappersOwn) {
  const Mapper mapper = drive(4);
  const MapSnapshot ours = snapshot_of(pieces_of(mapper.export_map()), mapper.decision());
  const MapSnapshotPtr its = mapper.snapshot();
  ASSERT_EQ(ours.voxels.size(), its->voxels.size());
  for (std::size_t i = 0; i < ours.voxels.size(); ++i) {
    EXPECT_EQ(ours.voxels[i].center, its->voxels[i].center);
    EXPECT_EQ(ours.voxels[i].log_odds, its->voxels[i].log_odds);
    EXPECT_EQ(ours.voxels[i].label, its->voxels[i].label);
  }
}

TEST(MapArchive, AMapOfOtherVoxelsIsNotImported) {
  Mapper mapper = drive(1);
  const std::size_t voxels = mapper.voxel_count();
  expect_error<std::invalid_argument>([&] { mapper.import_map(random_map(1, 1)); }, {"0.25", "0.1"});
  MapContents wrong = random_map(2, 2);
  wrong.voxel_size_m = 0.1;
  wrong.blocks[1].voxels.pop_back();
  expect_error<std::invalid_argument>([&] { mapper.import_map(wrong); }, {"places"});
  wrong.blocks[1] = {};
  wrong.blocks[1].key.x() = 1 << 20;
  expect_error<std::invalid_argument>([&] { mapper.import_map(wrong); }, {"limits"});
  EXPECT_EQ(mapper.voxel_count(), voxels);
}

}  // namespace
}  // namespace stillmap
