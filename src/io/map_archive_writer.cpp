#include "io/map_archive_writer.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "io/map_archive_format.hpp"

namespace stillmap {

using namespace map_archive;

MapArchiveWriter::MapArchiveWriter(const std::string& path, double voxel_size_m, std::int64_t stamp_ns)
    : path_(path), stream_(path, std::ios::binary) {
  std::string header = kMagic;
  LittleEndianWriter out(header);
  out.put(kVersion);
  out.put(voxel_size_m);
  out.put(stamp_ns);
  out.put(checksum(header));
  write(header);
}

void MapArchiveWriter::add(const BlockContents& block) {
  encode(block, section_);
  ++section_blocks_;
  ++blocks_;
  voxels_ += block.voxels.size();
  if (section_.size() + kMostBlockBytes > kMostSectionBytes) write_section();
}

void MapArchiveWriter::write_section() {
  std::string head;
  LittleEndianWriter out(head);
  out.put(section_blocks_);
  out.put(static_cast<std::uint32_t>(section_.size()));
  out.put(checksum(section_, checksum(head)));
  write(head);
  write(section_);
  section_.clear();
  section_blocks_ = 0;
}

void MapArchiveWriter::finish() {
  if (section_blocks_ > 0) write_section();
  LittleEndianWriter out(section_);
  out.put(blocks_);
  out.put(voxels_);
  write_section();
  if (!stream_.flush()) throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

void MapArchiveWriter::write(const std::string& bytes) {
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream_) throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace stillmap
