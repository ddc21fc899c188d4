#include "io/atomic_file.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

std::size_t files_in(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) count += entry.exists();
  return count;
}

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  write_text_atomically(folder.path("a.txt"), "old");
  write_text_atomically(folder.path("a.txt"), "new");
  EXPECT_EQ(read_text(folder.path("a.txt")), "new");
  EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicFile, KeepsTheOldContentWhenWritingFails) {
  const TemporaryFolder folder;
  write_text_atomically(folder.path("a.txt"), "old");
  const auto fail_half_way = [&](const std::string& file) {
    std::ofstream(file) << "half";
    throw std::runtime_error("power cut");
  };
  expect_error([&] { write_atomically(folder.path("a.txt"), fail_half_way); }, {"power cut"});
  EXPECT_EQ(read_text(folder.path("a.txt")), "old");
  EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicFile, TheNewFileKeepsTheExtension) {
  const TemporaryFolder folder;
  write_atomically(folder.path("map.pcd"), [&](const std::string& file) {
    EXPECT_NE(file, folder.path("map.pcd"));
    EXPECT_EQ(std::filesystem::path(file).extension(), ".pcd");
    EXPECT_EQ(std::filesystem::path(file).parent_path(),
              std::filesystem::path(folder.path("map.pcd")).parent_path());
    std::ofstream(file) << "x";
  });
}

TEST(AtomicFile, RefusesAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  expect_error([&] { write_text_atomically(folder.path("no/a.txt"), "x"); }, {"no/a.txt", "does not exist"});
}

TEST(AtomicFile, RefusesATargetThatIsAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("a.txt/full"));
  expect_error([&] { write_text_atomically(folder.path("a.txt"), "x"); }, {"a.txt", "cannot be written"});
  EXPECT_EQ(files_in(folder), 1u);
}

}  // namespace
}  // namespace stillmap
