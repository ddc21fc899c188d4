#include "io/map_archive_reader.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "io/map_archive_format.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

using namespace map_archive;

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}
[[noreturn]] void refuse_damaged(const std::string& path, const std::string& what) {
  refuse(path, "the map is damaged: " + what + "; take a backup, or map anew");
}

}  // namespace

MapArchiveReader::MapArchiveReader(const std::string& path) : path_(path), stream_(path, std::ios::binary) {
  if (!stream_) refuse(path_, std::string("cannot be opened: ") + std::strerror(errno));
  std::string magic(kMagicBytes, '\0');
  stream_.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  if (!stream_ || magic != kMagic)
    refuse(path_, "not a .stillmap file; give one that `save_map` or `stillmap` wrote");
  const std::string fields = read(kHeaderBytes - kMagicBytes);
  LittleEndianReader in(fields);
  const auto version = in.get<std::uint32_t>();
  if (version != kVersion)
    refuse(path_, "a map of format " + std::to_string(version) + ", and this stillmap reads format " +
                      std::to_string(kVersion) + "; use the stillmap that wrote it, or map anew");
  voxel_size_m_ = in.get<double>();
  stamp_ns_ = in.get<std::int64_t>();
  if (in.get<std::uint32_t>() != checksum(magic + fields.substr(0, fields.size() - 4)))
    refuse_damaged(path_, "its header does not match its checksum");
  Parameters parameters;  // a map of a size that no stillmap has would make others count without end
  parameters.voxel_size_m = voxel_size_m_;
  const std::vector<std::string> found = problems(parameters);
  if (!found.empty()) refuse_damaged(path_, found.front());
}

bool MapArchiveReader::next(std::vector<BlockContents>& blocks) {
  const std::string head = read(kSectionHeadBytes);
  LittleEndianReader in(head);
  const auto count = in.get<std::uint32_t>();
  const auto bytes = in.get<std::uint32_t>();
  // Before the checksum can be looked at: neither number may ask for much memory.
  if (bytes > kMostSectionBytes || std::size_t{count} * kBlockHeadBytes > bytes)
    refuse_damaged(path_, "a section of " + std::to_string(count) + " blocks in " + std::to_string(bytes) +
                              " bytes cannot be");
  const std::string payload = read(bytes);
  if (in.get<std::uint32_t>() != checksum(payload, checksum(head.substr(0, 8))))
    refuse_damaged(path_, "a section does not match its checksum");
  if (count == 0) return end(payload);
  LittleEndianReader section(payload);
  for (std::uint32_t i = 0; i < count; ++i) {
    BlockContents& block = blocks.emplace_back();
    if (!decode(section, block)) refuse_damaged(path_, "a section is shorter than its blocks");
    if (*problem(block) != '\0') refuse_damaged(path_, problem(block));
    voxels_ += block.voxels.size();
  }
  if (section.rest() > 0) refuse_damaged(path_, "a section is longer than its blocks");
  blocks_ += count;
  return true;
}

bool MapArchiveReader::end(const std::string& totals) {
  LittleEndianReader in(totals);
  if (totals.size() != kEndBytes || in.get<std::uint64_t>() != blocks_ || in.get<std::uint64_t>() != voxels_)
    refuse_damaged(path_, "sections are missing");
  if (stream_.peek() != std::ifstream::traits_type::eof()) refuse_damaged(path_, "something follows its end");
  return false;
}

std::string MapArchiveReader::read(std::size_t bytes) {
  std::string buffer(bytes, '\0');
  stream_.read(buffer.data(), static_cast<std::streamsize>(bytes));
  if (!stream_) refuse(path_, "the map is cut off; was the copy or the disk's write completed?");
  return buffer;
}

}  // namespace stillmap
