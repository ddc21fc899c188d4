// A recorded bag, message by message with flow control: the node's labels are the command line's, row by row,
// and the three clouds partition the input.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "messages/fields_of.hpp"
#include "messages/point_cloud_conversion.hpp"
#include "ros/node_harness.hpp"
#include "stillmap/types.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;
using sensor_msgs::PointCloud2;
using sensor_msgs::PointCloud2ConstPtr;

std::uint32_t label_in_file(std::uint8_t label) {
  return label == static_cast<int>(Label::kStatic) ? 9 : label == static_cast<int>(Label::kDynamic) ? 251 : 0;
}

std::vector<std::uint32_t> read_labels(const fs::path& file) {
  std::vector<std::uint32_t> labels(fs::file_size(file) / 4);
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(labels.data()), static_cast<std::streamsize>(4 * labels.size()));
  return labels;
}

std::vector<std::uint8_t> column(const PointCloud2& cloud, const std::string& name) {
  std::vector<std::uint8_t> values;
  for (const auto& field : cloud.fields)
    if (field.name == name)
      for (std::size_t i = 0; i < row_count(cloud); ++i) values.push_back(row_data(cloud, i)[field.offset]);
  return values;
}

void expect_labels(const PointCloud2& cloud, const fs::path& file) {
  const std::vector<std::uint32_t> expected = read_labels(file);
  const std::vector<std::uint8_t> labels = column(cloud, "label");
  ASSERT_EQ(labels.size(), expected.size()) << file;
  std::size_t different = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) different += label_in_file(labels[i]) != expected[i];
  EXPECT_EQ(different, 0u) << file;
}

// Walking the input, each row is the next one of exactly one of the three.
void expect_partition(const PointCloud2& input, const Answer& answer) {
  const std::vector<std::uint8_t> labels = column(*answer.labelled_points, "label");
  const PointCloud2* const parts[] = {answer.uncertain_points.get(), answer.static_points.get(),
                                      answer.dynamic_points.get()};
  std::size_t next[3] = {0, 0, 0};
  for (std::size_t i = 0; i < row_count(input); ++i) {
    const std::size_t part = labels[i] == static_cast<int>(Label::kInvalid) ? 0 : labels[i];
    ASSERT_LT(next[part], row_count(*parts[part]));
    const std::uint8_t* row = row_data(*parts[part], next[part]++);
    ASSERT_TRUE(std::equal(row, row + input.point_step, row_data(input, i))) << "row " << i;
  }
  for (int part = 0; part < 3; ++part) {
    EXPECT_EQ(next[part], row_count(*parts[part]));
    EXPECT_EQ(fields_of(*parts[part]), fields_of(input));
    EXPECT_EQ(parts[part]->header.stamp, input.header.stamp);
    EXPECT_EQ(parts[part]->header.frame_id, input.header.frame_id);
  }
}

// The input with three fields more; a `label` that it has itself is renamed.
void expect_all_fields(const PointCloud2& input, const PointCloud2& output) {
  EXPECT_EQ(output.header.stamp, input.header.stamp);
  ASSERT_EQ(row_count(output), row_count(input));
  ASSERT_EQ(output.fields.size(), input.fields.size() + 3);
  for (std::size_t i = 0; i < row_count(input); ++i)
    ASSERT_TRUE(std::equal(row_data(input, i), row_data(input, i) + input.point_step, row_data(output, i)));
}

std::string name_of(std::size_t k) {
  std::ostringstream name;
  name << std::setw(6) << std::setfill('0') << k << ".label";
  return name.str();
}

TEST(Flow, TheNodeSaysWhatTheCommandLineSays) {
  const fs::path out = fs::temp_directory_path() / ("stillmap_flow_" + std::to_string(getpid()));
  const std::string command =
      STILLMAP_COMMAND " label " STILLMAP_BAG " " + out.string() + " --no-final --delay 5";
  unsetenv("LD_PRELOAD");  // a sanitizer's runtime, which the shell does not bear
  ASSERT_EQ(std::system(command.c_str()), 0) << command;

  NodeHarness harness;
  ASSERT_TRUE(harness.wait_for_connections());
  rosbag::Bag bag(STILLMAP_BAG);
  rosbag::View odometry_view(bag, rosbag::TopicQuery("/Odometry"));
  rosbag::View cloud_view(bag, rosbag::TopicQuery("/cloud_registered"));
  auto odometry = odometry_view.begin();
  std::size_t k = 0, dynamic_points = 0, changed = 0;
  std::vector<PointCloud2ConstPtr> clouds;
  for (const rosbag::MessageInstance& message : cloud_view) {
    const auto cloud = message.instantiate<PointCloud2>();
    harness.publish(*cloud);  // before its pose: the order of arrival must not matter
    harness.publish(*(odometry++)->instantiate<nav_msgs::Odometry>());
    const Answer* answer = harness.answer(cloud->header.stamp);
    ASSERT_NE(answer, nullptr) << "scan " << k;
    expect_partition(*cloud, *answer);
    expect_labels(*answer->labelled_points, out / "online" / name_of(k++));
    dynamic_points += row_count(*answer->dynamic_points);
    clouds.push_back(cloud);
    if (k > 5) {
      ASSERT_NE(harness.resolved(clouds[k - 6]->header.stamp), nullptr) << "5 scans after " << k - 6;
    }
    EXPECT_EQ(harness.resolved(cloud->header.stamp, 0), nullptr) << "not before its time";
  }
  for (k = 0; k < clouds.size(); ++k) {  // the last five come when the scans have ceased
    const PointCloud2ConstPtr resolved = harness.resolved(clouds[k]->header.stamp);
    ASSERT_NE(resolved, nullptr) << "scan " << k;
    expect_all_fields(*clouds[k], *resolved);
    expect_labels(*resolved, out / "delayed" / name_of(k));
    changed += read_labels(out / "delayed" / name_of(k)) != read_labels(out / "online" / name_of(k));
  }
  EXPECT_GT(changed, 10u) << "waiting must settle something";
  EXPECT_GE(k, 10u);
  EXPECT_GT(dynamic_points, 0u) << "the bag must have something to find";
  fs::remove_all(out);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "flow_test");
  return RUN_ALL_TESTS();
}
