#include "io/map_archive.hpp"

#include "io/atomic_file.hpp"
#include "io/map_archive_reader.hpp"
#include "io/map_archive_writer.hpp"

namespace stillmap {

void write_map_archive(const MapContents& map, const std::string& path) {
  write_atomically(path, [&](const std::string& file) {
    MapArchiveWriter writer(file, map.voxel_size_m, map.stamp_ns);
    for (const BlockContents& block : map.blocks) writer.add(block);
    writer.finish();
  });
}

MapContents read_map_archive(const std::string& path) {
  MapArchiveReader reader(path);
  MapContents map{reader.stamp_ns(), reader.voxel_size_m(), {}};
  while (reader.next(map.blocks)) {
  }
  return map;
}

}  // namespace stillmap
