// rosbag records every output, and plays it back: the same messages of the same types, byte for byte.

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <signal.h>
#include <stillmap/DiffMap.h>
#include <stillmap/ExplainPoint.h>
#include <stillmap/SaveMap.h>

#include <filesystem>

#include "ros/loaded_nodelet.hpp"
#include "ros/node_interface.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;
constexpr int kScans = 20;

class Recording : public LoadedNodelet {
 protected:
  /// Starts rosbag record; it is ready when its file is there and it listens to all the outputs below
  /// `prefix`.
  void start_recorder(const std::string& prefix, const std::string& name) {
    const std::string pid_file = folder_.path(name + ".pid"), file = bag_file(name);
    ASSERT_TRUE(run("rosbag record --quiet -e '" + prefix + ".*' -O " + file + " __name:=" + name +
                    " & echo $! > " + pid_file));
    pid_ = std::stoi(read_text(pid_file));
    ASSERT_TRUE(harness_->wait_until([&] { return fs::exists(file + ".active"); }, 60));
  }
  void stop_recorder(const std::string& name) {
    kill(pid_, SIGINT);
    ASSERT_TRUE(harness_->wait_until([&] { return fs::exists(bag_file(name)); }, 60));
  }
  /// Some outputs are published when a service asks for them.
  void ask() {
    SaveMap save;
    DiffMap difference;
    ExplainPoint explanation;
    save.request.path = difference.request.path = folder_.path("map.stillmap");
    explanation.request.point.x = 4.99;
    explanation.request.point.z = 0.1;
    EXPECT_TRUE(ros::service::call("/stillmap/save_map", save) && save.response.success);
    EXPECT_TRUE(ros::service::call("/stillmap/diff_map", difference) && difference.response.success);
    EXPECT_TRUE(ros::service::call("/stillmap/explain_point", explanation) && explanation.response.success);
  }
  std::string bag_file(const std::string& name) const { return folder_.path(name + ".bag"); }

  TemporaryFolder folder_;
  pid_t pid_ = 0;
};

struct RecordedTopic {
  std::string type, md5;
  std::vector<std::vector<std::uint8_t>> messages;
};

RecordedTopic recorded(const rosbag::Bag& bag, const std::string& topic) {
  RecordedTopic found;
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& message : view) {
    found.type = message.getDataType();
    found.md5 = message.getMD5Sum();
    found.messages.emplace_back(message.size());
    ros::serialization::OStream stream(found.messages.back().data(), message.size());
    message.write(stream);
  }
  return found;
}

TEST_F(Recording, EveryOutputIsRecordedAndPlayed) {
  start_recorder("/stillmap/", "recorded");
  for (int i = 0; i < kScans; ++i) {
    ASSERT_NE(send(), nullptr);
    harness_->wait_until([] { return false; }, 0.2);  // the recorder must find the topics
  }
  ask();
  harness_->wait_until([] { return false; }, 1);
  stop_recorder("recorded");
  start_recorder("/played/", "played");
  ASSERT_TRUE(run("rosbag play --quiet --wait-for-subscribers --prefix=/played --bags=" +
                  bag_file("recorded") + " > /dev/null"));
  stop_recorder("played");

  const rosbag::Bag first(bag_file("recorded")), second(bag_file("played"));
  for (const Endpoint& output : published_topics()) {
    const RecordedTopic a = recorded(first, "/stillmap/" + output.name);
    const RecordedTopic b = recorded(second, "/played/stillmap/" + output.name);
    EXPECT_FALSE(a.messages.empty()) << output.name;
    EXPECT_EQ(a.type, output.type) << output.name;
    EXPECT_EQ(b.type, a.type) << output.name;
    EXPECT_EQ(b.md5, a.md5) << output.name;
    EXPECT_TRUE(b.messages == a.messages)
        << output.name << ": " << a.messages.size() << " recorded, " << b.messages.size() << " played";
  }
  EXPECT_EQ(recorded(first, "/stillmap/octomap").md5, "9a45536b45c5e409cd49f04bb2d9999f");
  // Who has the recording alone can read it: rostopic takes the definition from the bag.
  EXPECT_TRUE(run("rostopic echo -b " + bag_file("recorded") +
                  " -n 1 --noarr /stillmap/octomap | grep -q 'id: \"OcTree\"'"));
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "recording_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
