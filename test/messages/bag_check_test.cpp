// Bags that lie, made byte by byte: each is refused for what is wrong with it.

#include "messages/bag_check.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

template <class T>
std::string bytes_of(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
}
std::string counted(const std::string& bytes) {
  return bytes_of(static_cast<std::uint32_t>(bytes.size())) + bytes;
}
using Fields = std::map<std::string, std::string>;
std::string record(char op, const Fields& fields, const std::string& data) {
  std::string header = counted("op=" + std::string(1, op));
  for (const auto& [name, value] : fields) header += counted(name + "=" + value);
  return counted(header) + counted(data);
}

struct MadeBag {
  std::string encryptor, compression = "none";
  std::uint32_t connection = 3, index_offset = 0, chunk_bytes_more = 0, chunk_moved = 0, index_moved = 0;
  std::uint32_t file_cut = 0;

  std::string bytes() const {
    const std::string magic = "#ROSBAG V2.0\n";
    const std::string message =
        record(2, {{"conn", bytes_of<std::uint32_t>(3)}, {"time", bytes_of<std::uint64_t>(1)}}, "x");
    const auto file_header = [&](std::uint64_t index_at) {
      return record(3,
                    {{"index_pos", bytes_of(index_at)},
                     {"conn_count", bytes_of<std::uint32_t>(0)},
                     {"chunk_count", bytes_of<std::uint32_t>(1)},
                     {"encryptor", encryptor}},
                    std::string(20, ' '));
    };
    const auto size = static_cast<std::uint32_t>(message.size()) + chunk_bytes_more;
    const std::string chunk = record(5, {{"compression", compression}, {"size", bytes_of(size)}}, message);
    const std::string index = record(4,
                                     {{"ver", bytes_of<std::uint32_t>(1)},
                                      {"conn", bytes_of(connection)},
                                      {"count", bytes_of<std::uint32_t>(1)}},
                                     bytes_of<std::uint64_t>(1) + bytes_of(index_offset));
    const std::uint64_t chunk_at = magic.size() + file_header(0).size();
    const std::uint64_t index_at = chunk_at + chunk.size() + index.size();
    const std::string info = record(6,
                                    {{"ver", bytes_of<std::uint32_t>(1)},
                                     {"chunk_pos", bytes_of(chunk_at + chunk_moved)},
                                     {"count", bytes_of<std::uint32_t>(0)}},
                                    "");
    const std::string whole = magic + file_header(index_at + index_moved) + chunk + index + info;
    return whole.substr(0, whole.size() - file_cut);
  }
};

struct BagCheck : testing::Test {
  TemporaryFolder folder;
  void expect_refused(const MadeBag& bag, const std::string& why) {
    const std::string file = folder.write("a.bag", bag.bytes());
    expect_error([&] { check_bag(file); }, {file, why});
  }
};

TEST_F(BagCheck, TakesOneThatIsTrue) {
  check_bag(folder.write("a.bag", MadeBag().bytes()));
}

TEST_F(BagCheck, RefusesToLoadThePluginThatABagNames) {
  MadeBag bag;
  bag.encryptor = "rosbag/AesCbcEncryptor";
  expect_refused(bag, "it is encrypted");
}

TEST_F(BagCheck, RefusesSizesAndPlacesThatAreNotSo) {
  MadeBag bag;
  bag.index_offset = 1;
  expect_refused(bag, "an index names a message that is not there");
  bag = {};
  bag.connection = 4;
  expect_refused(bag, "an index names a message that is not there");
  bag = {};
  bag.chunk_bytes_more = 1;
  expect_refused(bag, "a chunk is not of the size that it says");
  bag = {};
  bag.chunk_moved = 4;
  expect_refused(bag, "what is said of a chunk is not so");
  bag = {};
  bag.index_moved = 2;
  expect_refused(bag, "its index is not where it says");
  bag = {};
  bag.file_cut = 1;
  expect_refused(bag, "reaches past its end");
}

TEST_F(BagCheck, RefusesChunksThatCannotBeUnpackedOrAreTooLarge) {
  MadeBag bag;
  for (const char* compression : {"bz2", "lz4", "zip"}) {
    bag.compression = compression;
    expect_refused(bag, "a chunk cannot be unpacked");
  }
  bag.compression = "bz2";
  bag.chunk_bytes_more = 1U << 30;
  expect_refused(bag, "bytes is too large");
}

TEST_F(BagCheck, RefusesWhatIsNoFile) {
  expect_error([&] { check_bag(folder.path()); }, {folder.path(), "not a file"});
  expect_error([&] { check_bag(folder.path("none.bag")); }, {"none.bag", "No such file"});
  expect_error([&] { check_bag(folder.write("empty.bag", "")); }, {"empty.bag", "does not begin as a bag"});
}

}  // namespace
}  // namespace stillmap
