#include "io/map_archive.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "io/atomic_file.hpp"
#include "io/map_archive_reader.hpp"
#include "io/map_archive_writer.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

MapContents read_file(const std::string& path) {
  MapArchiveReader reader(path);
  MapContents map{reader.stamp_ns(), reader.voxel_size_m(), {}};
  while (reader.next(map.blocks)) {
  }
  return map;
}

MapContents read_folder(const std::string& path) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".stillmap" && entry.path().filename().string().front() != '.')
      files.push_back(entry.path().string());
  if (files.empty()) throw std::runtime_error(path + ": a folder without .stillmap files; give a map");
  std::sort(files.begin(), files.end());
  MapContents map = read_file(files.front());
  for (auto file = files.begin() + 1; file != files.end(); ++file) {
    MapContents tile = read_file(*file);
    if (tile.voxel_size_m != map.voxel_size_m)
      throw std::runtime_error(*file + ": its voxels are " + std::to_string(tile.voxel_size_m) +
                               " m large, those of the others in the folder " +
                               std::to_string(map.voxel_size_m));
    map.stamp_ns = std::max(map.stamp_ns, tile.stamp_ns);
    std::move(tile.blocks.begin(), tile.blocks.end(), std::back_inserter(map.blocks));
  }
  return map;
}

}  // namespace

void write_map_archive(const MapPieces& map, const std::string& path) {
  write_atomically(path, [&](const std::string& file) {
    MapArchiveWriter writer(file, map.voxel_size_m, map.stamp_ns);
    for (std::vector<BlockContents> blocks; map.next(blocks); blocks.clear())
      for (const BlockContents& block : blocks) writer.add(block);
    writer.finish();
  });
}

MapContents read_map_archive(const std::string& path) {
  return fs::is_directory(path) ? read_folder(path) : read_file(path);
}

}  // namespace stillmap
