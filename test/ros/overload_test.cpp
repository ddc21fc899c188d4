// Scans at up to three times the rate that the node can take: it drops whole scans, oldest first, and counts
// them; latency and memory stay bounded, and the map is not harmed. Prints a table.

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/init.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "messages/make_cloud.hpp"
#include "ros/child_process.hpp"
#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

constexpr int kQueue = 5;
constexpr double kSeconds = 6;

/// The walls of the room, densely: what takes the node tens of milliseconds.
const std::vector<Eigen::Vector3d>& dense_room() {
  static const std::vector<Eigen::Vector3d> points = [] {
    std::vector<Eigen::Vector3d> dense;
    for (const Eigen::Vector3d& point : room_points())
      for (int i = 0; i < 12; ++i)
        dense.push_back(Eigen::AngleAxisd(i * 0.0014, Eigen::Vector3d::UnitZ()) * point);
    return dense;
  }();
  return points;
}

class Overload : public testing::Test {
 protected:
  Overload()
      : clouds_(nh_.advertise<sensor_msgs::PointCloud2>("/cloud_registered", 1000)),
        odometry_(nh_.advertise<nav_msgs::Odometry>("/Odometry", 1000)),
        node_({STILLMAP_NODE, "__name:=stillmap", "_cloud_frame:=sensor", "_threads:=1",
               "_queue_size:=" + std::to_string(kQueue)}) {
    const boost::function<void(const StatusConstPtr&)> keep = [this](const StatusConstPtr& status) {
      answered_.push_back(status->header.stamp);
      latency_ms_.push_back((ros::WallTime::now() - sent_[status->header.stamp]).toSec() * 1e3);
      status_ = *status;
    };
    subscriber_ = nh_.subscribe<Status>("/stillmap/status", 1000, keep);
    EXPECT_TRUE(NodeHarness::wait_until([this] {
      return clouds_.getNumSubscribers() > 0 && odometry_.getNumSubscribers() > 0 &&
             subscriber_.getNumPublishers() > 0;
    }));
  }

  ros::Time send() {
    const nav_msgs::Odometry odometry = room_odometry(++k_);
    static const sensor_msgs::PointCloud2Ptr cloud = make_cloud(dense_room());
    cloud->header.stamp = odometry.header.stamp;
    sent_[odometry.header.stamp] = ros::WallTime::now();
    odometry_.publish(odometry);
    clouds_.publish(*cloud);
    return odometry.header.stamp;
  }
  bool has_come(const ros::Time& stamp) {
    return NodeHarness::wait_until([&] { return !answered_.empty() && answered_.back() == stamp; });
  }
  std::uint64_t dropped() const {
    std::uint64_t scans = 0;
    for (const std::uint64_t count : status_.dropped) scans += count;
    return scans;
  }
  /// Sends scans at this distance in time; the last of them.
  ros::Time send_every(double period_ms, int scans) {
    const ros::WallTime start = ros::WallTime::now();
    ros::Time last;
    for (int i = 1; i <= scans; ++i) {
      last = send();
      while (ros::WallTime::now() < start + ros::WallDuration(i * period_ms * 1e-3))
        ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.0005));
    }
    return last;
  }
  /// Between two answers when there is always a scan that waits.
  double turn_ms() {
    for (int i = 0; i < 30; ++i) EXPECT_TRUE(has_come(send()));  // the map, and the doctor's first scans
    for (double period_ms = latency_ms_.back() / 2;; period_ms /= 2) {
      const std::uint64_t dropped_before = dropped();
      answered_.clear();
      const ros::WallTime start = ros::WallTime::now();
      EXPECT_TRUE(has_come(send_every(period_ms, static_cast<int>(2e3 / period_ms))));
      const double elapsed_ms = (ros::WallTime::now() - start).toSec() * 1e3;
      const auto answered = static_cast<double>(answered_.size());
      for (int i = 0; i < 2; ++i) EXPECT_TRUE(has_come(send()));  // a status has the drops before its scan
      if (static_cast<double>(dropped() - dropped_before) > answered / 2) return elapsed_ms / answered;
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher clouds_, odometry_;
  ros::Subscriber subscriber_;
  std::map<ros::Time, ros::WallTime> sent_;
  std::vector<ros::Time> answered_;
  std::vector<double> latency_ms_;
  Status status_;
  int k_ = 0;
  ChildProcess node_;
};

TEST_F(Overload, DropsWholeScansOldestFirstAndStaysWithinItsBounds) {
  const double turn = turn_ms();
  const std::uint64_t voxels = status_.voxels;
  std::printf("a scan of %zu points takes %.1f ms; queue_size %d\n", dense_room().size(), turn, kQueue);
  std::printf("| load | offered | answered | dropped | p50 ms | p99 ms | most memory MB |\n");
  double quiet_mb = 0;
  for (const double load : {0.5, 1.0, 3.0}) {
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(has_come(send()));  // a status has the drops before its scan
    const std::uint64_t dropped_before = dropped();
    answered_.clear();
    latency_ms_.clear();
    const int offered = static_cast<int>(kSeconds * 1e3 / turn * load);
    EXPECT_TRUE(has_come(send_every(turn / load, offered)))
        << "the newest scan is never the one that is dropped";
    const std::size_t answered = answered_.size();
    EXPECT_TRUE(std::is_sorted(answered_.begin(), answered_.end()));
    std::sort(latency_ms_.begin(), latency_ms_.end());
    const double p50 = latency_ms_[answered / 2], p99 = latency_ms_[answered * 99 / 100];
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(has_come(send()));
    const std::uint64_t lost = dropped() - dropped_before;
    const double most_mb = memory_mb(node_.pid, "VmHWM");
    std::printf("| %.1f | %d | %zu | %llu | %.0f | %.0f | %.0f |\n", load, offered, answered,
                static_cast<unsigned long long>(lost), p50, p99, most_mb);
    EXPECT_EQ(answered + lost, static_cast<std::size_t>(offered)) << "each is answered or counted";
    if (load < 1) quiet_mb = most_mb;
    if (load < 2) continue;
    EXPECT_GT(lost, static_cast<std::uint64_t>(offered) / 4);
    const double period_ms = kSeconds * 1e3 / static_cast<double>(answered);
    EXPECT_LT(p99, 4 * (kQueue + 2) * period_ms);  // the queue, and what else runs on the machine
    EXPECT_LT(most_mb, quiet_mb + 100);
  }
  EXPECT_EQ(status_.voxels, voxels) << "the room is what it was";
  EXPECT_GT(status_.static_points, 0.98 * static_cast<double>(dense_room().size()));
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "overload_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
