// .stillmap files and tiles. Bytes with wrong checksums are refused early, so an even first byte has them
// made right: then the decoder and the mapper get what a foreign writer could have written.

#include <cstdint>

#include "expect.hpp"
#include "input.hpp"
#include "io/map_archive.hpp"
#include "io/map_archive_format.hpp"
#include "maps/map_diff.hpp"
#include "maps/map_merge.hpp"
#include "scratch_folder.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap::fuzz {
namespace {

using namespace map_archive;

void put_checksum(std::string& file, std::size_t at, std::uint32_t sum) {
  std::string bytes;
  LittleEndianWriter(bytes).put(sum);
  file.replace(at, bytes.size(), bytes);
}

void make_checksums_right(std::string& file) {
  if (file.size() < kHeaderBytes) return;
  put_checksum(file, kHeaderBytes - 4, checksum(file.substr(0, kHeaderBytes - 4)));
  for (std::size_t at = kHeaderBytes; at + kSectionHeadBytes <= file.size();) {
    const std::string numbers = file.substr(at, 8);
    LittleEndianReader in(numbers);
    in.get<std::uint32_t>();
    const std::size_t bytes = in.get<std::uint32_t>();
    if (at + kSectionHeadBytes + bytes > file.size()) return;
    put_checksum(file, at + 8, checksum(file.substr(at + kSectionHeadBytes, bytes), checksum(numbers)));
    at += kSectionHeadBytes + bytes;
  }
}

/// As `stillmap diff` and `merge` do.
void compare_and_merge(const MapContents& map) {
  MapContents shifted = map;
  if (!shifted.blocks.empty()) shifted.blocks.front().key.x() /= 2;
  diff(map, shifted, {0.7F, 0.3F}, DiffOptions());
  merge(shifted, map, {-5.0F, 5.0F});
  expect(shifted.blocks.size() <= 2 * map.blocks.size(), "a merged map has no more than both");
}

/// A mapper takes the map or refuses it, and then goes on with scans.
void map_on(const MapContents& map) {
  Parameters parameters;
  parameters.voxel_size_m = map.voxel_size_m;
  parameters.max_range_m = 10;
  expect_named_refusal("", [&] {
    Mapper mapper(parameters);
    mapper.import_map(map);
    Scan scan;
    for (int i = 0; i < 40; ++i) scan.points.emplace_back(3.0F, 0.1F * static_cast<float>(i - 20), 0.2F);
    mapper.process(scan, Eigen::Isometry3d::Identity());
    mapper.snapshot();
    MapContents again = mapper.export_map();
    expect(again.blocks.size() >= 1, "the scan's voxels are in the map");
  });
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stillmap::fuzz;
  Input in(data, size);
  const bool checksums_are_right = in.choose(2) == 0;
  std::string bytes = in.take_all();
  if (checksums_are_right) make_checksums_right(bytes);
  const std::string file = ScratchFolder::instance().write("given.stillmap", bytes);
  expect_named_refusal(file, [&] {
    const stillmap::MapContents map = stillmap::read_map_archive(file);
    compare_and_merge(map);
    map_on(map);
  });
  return 0;
}
