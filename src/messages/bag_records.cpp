#include "messages/bag_records.hpp"

namespace stillmap {
namespace {

/// A length in 4 bytes at `at`, and so many bytes; moves `at` behind them.
std::string_view counted(std::string_view bytes, std::size_t& at) {
  std::uint32_t length = 0;
  const std::size_t rest = bytes.size() - at;
  if (rest >= sizeof(length)) std::memcpy(&length, bytes.data() + at, sizeof(length));
  if (rest < sizeof(length) || length > rest - sizeof(length))
    throw std::runtime_error("what begins at byte " + std::to_string(at) + " reaches past its end");
  const std::string_view found = bytes.substr(at + sizeof(length), length);
  at += sizeof(length) + length;
  return found;
}

}  // namespace

std::map<std::string_view, std::string_view> bag_fields(std::string_view bytes) {
  std::map<std::string_view, std::string_view> fields;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::string_view field = counted(bytes, at);
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) throw std::runtime_error("a field of a record has no value");
    if (!fields.emplace(field.substr(0, equals), field.substr(equals + 1)).second)
      throw std::runtime_error("a field of a record comes twice");
  }
  return fields;
}

bool BagRecords::next(BagRecord& record) {
  if (at_ == bytes_.size()) return false;
  record.at = at_;
  record.fields = bag_fields(counted(bytes_, at_));
  record.data = counted(bytes_, at_);
  return true;
}

}  // namespace stillmap
