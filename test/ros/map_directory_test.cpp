#include "ros/map_directory.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

TEST(MapDirectory, TakesFilesInsideByEitherName) {
  const TemporaryFolder folder;
  const MapDirectory maps(folder.path("maps"));
  EXPECT_EQ(maps.file_inside("a.pcd"), folder.path("maps/a.pcd"));
  EXPECT_EQ(maps.file_inside(folder.path("maps/deep/a.pcd")), folder.path("maps/deep/a.pcd"));
  EXPECT_EQ(maps.file_inside("x/../a.pcd"), folder.path("maps/a.pcd"));
  EXPECT_FALSE(fs::exists(folder.path("maps"))) << "asking makes nothing";
}

TEST(MapDirectory, RefusesWhatLiesElsewhere) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path("maps"));
  fs::create_directory_symlink(folder.path(), folder.path("maps/link"));
  folder.write("secret.stillmap", "");
  fs::create_symlink(folder.path("secret.stillmap"), folder.path("maps/file_link"));
  const MapDirectory maps(folder.path("maps"));
  for (const std::string& path : {std::string("/etc/passwd"), std::string("../a.pcd"),
                                  std::string("link/a.pcd"), std::string("file_link"), std::string("."),
                                  folder.path("maps_of_others/a.pcd"), folder.path("maps/../../a.pcd")})
    expect_error([&] { maps.file_inside(path); }, {path, "outside of map_directory", folder.path("maps")});
  expect_error([&] { maps.file_inside(""); }, {"empty"});
}

TEST(MapDirectory, KeepsAFileThatIsThere) {
  const TemporaryFolder folder;
  const MapDirectory maps(folder.path("maps"));
  const std::string file = maps.new_file_inside("a.pcd", false);
  EXPECT_TRUE(fs::is_directory(folder.path("maps")));
  folder.write("maps/a.pcd", "x");
  expect_error([&] { maps.new_file_inside("a.pcd", false); }, {file, "is there already", "overwrite: true"});
  EXPECT_EQ(maps.new_file_inside("a.pcd", true), file);
}

TEST(MapDirectory, BeginsInTheHomeFolder) {
  const TemporaryFolder home;
  const char* const before = std::getenv("HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("HOME", home.path().c_str(), 1);
  EXPECT_EQ(MapDirectory("~/maps").file_inside("a.pcd"),
            (fs::path(home.path()) / "maps/a.pcd").lexically_normal());
  setenv("HOME", kept.c_str(), 1);
}

}  // namespace
}  // namespace stillmap
