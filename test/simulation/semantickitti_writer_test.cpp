// What stands in the files, byte for byte.
#include "io/semantickitti_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace stillmap {
namespace {

namespace fs = std::filesystem;

class SemanticKittiWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("stillmap_writer_" + std::to_string(getpid()) + "_" + test);
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_;
};

Frame two_points() {
  Frame frame;
  frame.name = "000007";
  frame.scan.stamp_ns = 1'050'000'001;
  frame.scan.points = {{1, 2, 3}, {-4, 0.5F, 6}};
  frame.T_map_sensor.translation() = Eigen::Vector3d(10, 20.25, 30);
  return frame;
}

TEST_F(SemanticKittiWriterTest, WritesTheLayout) {
  {
    SemanticKittiWriter writer(folder_.string());
    writer.write(two_points(), {0.25F, 0.5F}, {252U | 3U << 16, 40}, {10U | 3U << 16, 40});
  }
  const float rows[] = {1, 2, 3, 0.25F, -4, 0.5F, 6, 0.5F};
  const std::string velodyne = content(folder_ / "velodyne/000007.bin");
  ASSERT_EQ(velodyne.size(), sizeof(rows));
  EXPECT_EQ(std::memcmp(velodyne.data(), rows, sizeof(rows)), 0);
  const std::uint32_t labels[] = {252U | 3U << 16, 40};
  EXPECT_EQ(content(folder_ / "labels/000007.label"),
            std::string(reinterpret_cast<const char*>(labels), sizeof(labels)));
  EXPECT_EQ(content(folder_ / "labels_now/000007.label").size(), sizeof(labels));
  EXPECT_EQ(content(folder_ / "poses.txt"), "1 0 0 10 0 1 0 20.25 0 0 1 30\n");
  EXPECT_EQ(content(folder_ / "times.txt"), "1.050000001\n");
  EXPECT_NE(content(folder_ / "calib.txt").find("Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n"), std::string::npos);
}

TEST_F(SemanticKittiWriterTest, RefusesToMixTwoSequences) {
  { SemanticKittiWriter writer(folder_.string()); }
  EXPECT_THROW(SemanticKittiWriter(folder_.string()), std::runtime_error);
}

TEST_F(SemanticKittiWriterTest, RefusesListsOfAnotherLength) {
  SemanticKittiWriter writer(folder_.string());
  EXPECT_THROW(writer.write(two_points(), {0.25F}, {40, 40}, {40, 40}), std::invalid_argument);
  EXPECT_THROW(writer.write(two_points(), {0, 0}, {40}, {40, 40}), std::invalid_argument);
  EXPECT_EQ(content(folder_ / "poses.txt"), "");
}

TEST_F(SemanticKittiWriterTest, NamesTheFolderItCannotMake) {
  std::ofstream(folder_) << "a file stands in the way";
  try {
    SemanticKittiWriter writer((folder_ / "sequence").string());
    FAIL() << "not refused";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(folder_.string()), std::string::npos);
  }
}

}  // namespace
}  // namespace stillmap
