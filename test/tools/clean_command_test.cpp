// `stillmap clean` on a simulated street: what moves is known from the field `label` of its clouds.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_msgs/Header.h>

#include <cmath>

#include "messages/bag_writer.hpp"
#include "support/run_command.hpp"

namespace stillmap {
namespace {

constexpr int kScans = 25;

/// Points of one kind, and how many of them are left.
struct Kept {
  std::size_t moving = 0, standing = 0;
  void add(const sensor_msgs::PointCloud2& cloud) {
    if (cloud.data.empty()) return;  // the iterators look at the first byte
    sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(cloud, "label");
    sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
    for (; label != label.end(); ++label, ++x) {
      if (std::isnan(*x)) continue;
      const std::uint32_t semantic_class = *label & 0xFFFFU;
      ++(semantic_class >= 251 && semantic_class <= 259 ? moving : standing);
    }
  }
};

struct Recording {
  /// Every message of the other topics, by topic: rosbag gives those of one time in any order.
  std::map<std::string, std::vector<std::string>> others;
  std::map<std::string, std::vector<sensor_msgs::PointCloud2ConstPtr>> clouds;

  explicit Recording(const std::string& file) {
    rosbag::Bag bag(file);
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
      if (const auto cloud = message.instantiate<sensor_msgs::PointCloud2>()) {
        clouds[message.getTopic()].push_back(cloud);
        continue;
      }
      std::vector<char> bytes(message.size());
      ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()), message.size());
      message.write(stream);
      others[message.getTopic()].push_back(
          message.getDataType() + " " + (message.isLatching() ? "latched " : "") +
          std::to_string(message.getTime().toNSec()) + std::string(bytes.begin(), bytes.end()));
    }
  }
  Kept count(const std::string& topic) const {
    Kept kept;
    for (const auto& cloud : clouds.at(topic)) kept.add(*cloud);
    return kept;
  }
};

struct CleanCommandTest : testing::Test {
  inline static const std::string kTopic = "/cloud_registered";
  static TemporaryFolder& folder() {
    static TemporaryFolder folder;
    return folder;
  }
  static std::string in() { return folder().path("in.bag"); }
  std::string out = folder().path("out.bag");

  static void SetUpTestSuite() {
    const CommandResult made = run_command(
        STILLMAP_EXECUTABLE, "simulate street " + in() + " --sensor vlp16 --scans " + std::to_string(kScans));
    ASSERT_EQ(made.status, 0) << made.output;
    // A cloud that no odometry goes with, and a latched message of another topic.
    sensor_msgs::PointCloud2 late = *Recording(in()).clouds.at(kTopic).front();
    late.header.stamp = ros::Time(BagWriter::kBagEpoch_s + 900);
    std_msgs::Header note;
    note.frame_id = "kept";
    const auto latched = boost::make_shared<ros::M_string>();
    *latched = {{"latching", "1"},
                {"callerid", "/somebody"},
                {"md5sum", ros::message_traits::md5sum(note)},
                {"type", ros::message_traits::datatype(note)},
                {"message_definition", ros::message_traits::definition(note)}};
    rosbag::Bag bag(in(), rosbag::bagmode::Append);
    bag.write(kTopic, late.header.stamp, late);
    bag.write("/note", ros::Time(BagWriter::kBagEpoch_s + 1), note, latched);
  }

  Recording clean(const std::string& options) const {
    const CommandResult result =
        run_command(STILLMAP_EXECUTABLE, "clean " + in() + " " + out + " " + options);
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_NE(result.output.find("1 of 26 clouds have no pose"), std::string::npos) << result.output;
    return Recording(out);
  }
};

TEST_F(CleanCommandTest, MovingPointsGoAndAllElseStays) {
  const Recording before(in()), after = clean("");
  ASSERT_EQ(before.others.size(), 3u);
  EXPECT_EQ(before.others.at("/note").size(), 1u);
  EXPECT_GE(before.others.at("/Odometry").size(), std::size_t{kScans});
  EXPECT_EQ(after.others, before.others);  // /Odometry, /tf, /note: each in order, bit by bit
  ASSERT_EQ(after.clouds.size(), 1u);
  ASSERT_EQ(after.clouds.at(kTopic).size(), before.clouds.at(kTopic).size());
  const auto &kept = *after.clouds.at(kTopic).back(), &late = *before.clouds.at(kTopic).back();
  EXPECT_EQ(kept.data, late.data);  // no pose: uncertain as a whole
  Kept all = before.count(kTopic), left = after.count(kTopic);
  const double moving = 100.0 * left.moving / all.moving, standing = 100.0 * left.standing / all.standing;
  std::cout << "left of what moves " << moving << " %, of what stands " << standing << " %\n";
  EXPECT_LT(moving, 20);
  EXPECT_GT(standing, 99);
}

TEST_F(CleanCommandTest, MaskedRowsStayInPlace) {
  const Recording before(in()), after = clean("--as masked --static-only");
  const auto &was = before.clouds.at(kTopic), &is = after.clouds.at(kTopic);
  ASSERT_EQ(is.size(), was.size());
  for (std::size_t k = 0; k < was.size(); ++k) EXPECT_EQ(is[k]->data.size(), was[k]->data.size());
  EXPECT_LT(after.count(kTopic).moving, before.count(kTopic).moving / 5);
  Kept late;
  late.add(*is.back());
  EXPECT_EQ(late.moving + late.standing, 0u);  // without a pose nothing is known to be static
}

TEST_F(CleanCommandTest, SplitAddsThreeTopicsThatAreTheCloud) {
  const Recording before(in()), after = clean("--as split --online");
  ASSERT_EQ(after.clouds.size(), 4u);
  const Kept all = before.count(kTopic), same = after.count(kTopic);
  EXPECT_EQ(same.moving + same.standing, all.moving + all.standing);
  std::size_t parts = 0;
  for (const char* part : {"/static", "/dynamic", "/uncertain"}) {
    const Kept kept = after.count(kTopic + part);
    parts += kept.moving + kept.standing;
  }
  EXPECT_EQ(parts, all.moving + all.standing);
  const Kept dynamic = after.count(kTopic + "/dynamic");
  EXPECT_GT(dynamic.moving, 10 * dynamic.standing);
}

TEST_F(CleanCommandTest, LabelsAreFieldsOfTheCloud) {
  const Recording after = clean("--as labels");
  for (const auto& cloud : after.clouds.at(kTopic)) {
    std::string names;
    for (const auto& field : cloud->fields) names += field.name + " ";
    EXPECT_EQ(names, "x y z intensity ring input_label p_static label reason ");
  }
}

/// Every second cloud is of another LiDAR.
TEST_F(CleanCommandTest, SeveralLidarsAreCleanedTogether) {
  const std::string two = folder().path("two.bag");
  {
    rosbag::Bag from(in()), to(two, rosbag::bagmode::Write);
    std::size_t clouds = 0;
    for (const rosbag::MessageInstance& message : rosbag::View(from)) {
      const bool is_rear = message.getTopic() == kTopic && clouds++ % 2 == 1;
      to.write(is_rear ? "/rear" : message.getTopic(), message.getTime(), message,
               message.getConnectionHeader());
    }
  }
  const CommandResult result =
      run_command(STILLMAP_EXECUTABLE, "clean " + two + " " + out + " --cloud-topic '" + kTopic +
                                           " /rear' --sensor-on-body '0 0 0 0 0 0; 0 0 0 0 0 0'");
  ASSERT_EQ(result.status, 0) << result.output;
  EXPECT_NE(result.output.find(kTopic + " /rear, 26 clouds"), std::string::npos) << result.output;
  const Recording before(two), after(out);
  for (const std::string& topic : {kTopic, std::string("/rear")}) {
    EXPECT_LT(after.count(topic).moving, before.count(topic).moving / 3) << topic;
    EXPECT_GT(after.count(topic).standing, before.count(topic).standing * 98 / 100) << topic;
  }
}

TEST_F(CleanCommandTest, RefusesToWriteOverItsInputAndKeepsAnOldFileWhenItFails) {
  CommandResult result = run_command(STILLMAP_EXECUTABLE, "clean " + in() + " " + in());
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("is the bag that is read"), std::string::npos) << result.output;
  folder().write("old.bag", "old");
  result = run_command(STILLMAP_EXECUTABLE,
                       "clean " + in() + " " + folder().path("old.bag") + " --cloud-topic /nothing");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("no topic /nothing"), std::string::npos) << result.output;
  EXPECT_EQ(read_text(folder().path("old.bag")), "old");
}

}  // namespace
}  // namespace stillmap
