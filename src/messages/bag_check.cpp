#include "messages/bag_check.hpp"

#include <bzlib.h>
#include <roslz4/lz4s.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "messages/bag_records.hpp"
#include "messages/mapped_file.hpp"

namespace stillmap {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::uint32_t kMostChunk_bytes = 1U << 28;  // unpacked; rosbag records 768 kB, or one message
constexpr std::size_t kIndexEntry_bytes = 12, kChunkCount_bytes = 8;

[[noreturn]] void refuse(const BagRecord& record, const std::string& what) {
  throw std::runtime_error(what + ", at byte " + std::to_string(record.at));
}

/// What the chunk holds; `buffer` has it when it is compressed.
std::string_view unpacked(const BagRecord& chunk, std::string& buffer) {
  auto size = chunk.number<std::uint32_t>("size");
  const std::string_view compression = chunk.fields.at("compression");
  if (compression == "none") {
    if (size != chunk.data.size()) refuse(chunk, "a chunk is not of the size that it says");
    return chunk.data;
  }
  if (size > kMostChunk_bytes) refuse(chunk, "a chunk of " + std::to_string(size) + " bytes is too large");
  buffer.resize(size);
  char* const from = const_cast<char*>(chunk.data.data());  // neither writes to it
  const auto from_bytes = static_cast<unsigned>(chunk.data.size());
  unsigned bytes = size;
  const bool is_whole =
      compression == "bz2"
          ? BZ2_bzBuffToBuffDecompress(buffer.data(), &bytes, from, from_bytes, 0, 0) == BZ_OK
      : compression == "lz4"
          ? roslz4_buffToBuffDecompress(from, from_bytes, buffer.data(), &bytes) == ROSLZ4_OK
          : false;
  if (!is_whole || bytes != size) refuse(chunk, "a chunk cannot be unpacked");
  return buffer;
}

/// Goes through a bag from its first to its last record.
class BagCheck {
 public:
  explicit BagCheck(std::string_view bytes) {
    if (bytes.substr(0, kMagic.size()) != kMagic) throw std::runtime_error("it does not begin as a bag");
    BagRecord record;
    std::size_t index_at = 0;
    for (BagRecords records(bytes, kMagic.size()); records.next(record);) {
      if (starts_.empty()) {
        check_file_header(record);
        index_at = record.number<std::uint64_t>("index_pos");
        if (index_at == 0) return;  // rosbag says so
      }
      starts_.insert(record.at);
      check(record);
    }
    if (starts_.count(index_at) == 0 && index_at != bytes.size())
      throw std::runtime_error("its index is not where it says, was the recording cut off?");
  }

 private:
  void check_file_header(const BagRecord& record) {
    if (record.op() != BagRecord::kFileHeader) refuse(record, "the first record is not a bag's");
    const auto encryptor = record.fields.find("encryptor");
    if (encryptor != record.fields.end() && !encryptor->second.empty())
      throw std::runtime_error("it is encrypted; write it anew with `rosbag decrypt`");
  }
  void check(const BagRecord& record) {
    switch (record.op()) {
      case BagRecord::kChunk:
        return check_chunk(record);
      case BagRecord::kIndex:
        return check_index(record);
      case BagRecord::kChunkInfo:
        if (chunks_.count(record.number<std::uint64_t>("chunk_pos")) == 0 ||
            record.data.size() != record.number<std::uint32_t>("count") * kChunkCount_bytes)
          refuse(record, "what is said of a chunk is not so");
        return;
      case BagRecord::kConnection:
        bag_fields(record.data);
    }
  }
  void check_chunk(const BagRecord& chunk) {
    if (chunk.fields.count("compression") == 0) refuse(chunk, "a chunk does not say how it is packed");
    chunks_.insert(chunk.at);
    messages_.clear();
    BagRecord record;
    for (BagRecords records(unpacked(chunk, buffer_)); records.next(record);) {
      if (record.op() == BagRecord::kMessage) messages_[record.at] = record.number<std::uint32_t>("conn");
      if (record.op() == BagRecord::kConnection) bag_fields(record.data);
    }
  }
  void check_index(const BagRecord& index) {
    const auto connection = index.number<std::uint32_t>("conn");
    if (index.data.size() != std::size_t{index.number<std::uint32_t>("count")} * kIndexEntry_bytes)
      refuse(index, "an index is not of the size that it says");
    for (std::size_t entry = 0; entry < index.data.size(); entry += kIndexEntry_bytes) {
      std::uint32_t offset = 0;
      std::memcpy(&offset, index.data.data() + entry + kIndexEntry_bytes - sizeof(offset), sizeof(offset));
      const auto message = messages_.find(offset);
      if (message == messages_.end() || message->second != connection)
        refuse(index, "an index names a message that is not there");
    }
  }

  std::set<std::size_t> starts_, chunks_;
  std::unordered_map<std::size_t, std::uint32_t>
      messages_;  ///< of the last chunk: where, and which connection
  std::string buffer_;
};

}  // namespace

void check_bag(const std::string& file) {
  const MappedFile mapped(file);
  try {
    BagCheck check(mapped.bytes());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": not a readable bag: " + error.what());
  }
}

}  // namespace stillmap
