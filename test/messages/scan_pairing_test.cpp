#include "messages/scan_pairing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "messages/expect_message.hpp"
#include "messages/make_cloud.hpp"

namespace stillmap {
namespace {

constexpr std::uint64_t kSecond_ns = 1'000'000'000, kTenth_ns = kSecond_ns / 10;
const Eigen::Vector3d kPoint(4, -1, 2);

nav_msgs::Odometry odometry(std::uint64_t stamp_ns, double x, double qw = 1) {
  nav_msgs::Odometry message;
  message.header.stamp.fromNSec(stamp_ns);
  message.pose.pose.position.x = x;
  message.pose.pose.orientation.w = qw;
  return message;
}

std::vector<std::uint64_t> stamps_of_all(ScanPairing& pairing) {
  std::vector<std::uint64_t> stamps;
  while (const auto paired = pairing.next()) stamps.push_back(paired->cloud->header.stamp.toNSec());
  return stamps;
}

TEST(ScanPairing, PairsByStampWhateverTheOrderOfArrival) {
  ScanPairing pairing(PairingOptions{});
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + kTenth_ns));
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns));
  EXPECT_FALSE(pairing.next());
  EXPECT_EQ(pairing.waiting_for(), "no odometry has come yet");
  pairing.add_odometry(odometry(kSecond_ns + kTenth_ns, 1));
  pairing.add_odometry(odometry(kSecond_ns, 0));
  const auto first = pairing.next(), second = pairing.next();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->cloud->header.stamp.toNSec(), kSecond_ns);
  EXPECT_EQ(first->T_map_sensor.translation().x(), 0);
  EXPECT_EQ(second->T_map_sensor.translation().x(), 1);
  EXPECT_TRUE(pairing.dropped().empty());
}

TEST(ScanPairing, WaitsForTheOdometryAfterTheStampThenInterpolates) {
  ScanPairing pairing(PairingOptions{});
  pairing.add_odometry(odometry(kSecond_ns, 0));
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + kTenth_ns / 2));
  EXPECT_FALSE(pairing.next());
  pairing.add_odometry(odometry(kSecond_ns + kTenth_ns, 1));
  const auto paired = pairing.next();
  ASSERT_TRUE(paired);
  EXPECT_NEAR(paired->T_map_sensor.translation().x(), 0.5, 1e-12);
}

// The same point of the sensor, told in each of the three frames.
TEST(ScanPairing, BringsEveryFrameBackToTheSensor) {
  PairingOptions options;
  options.T_body_sensor = parse_sensor_on_body("0.1 0.2 0.3 5 10 90");
  nav_msgs::Odometry message = odometry(kSecond_ns, 5000);
  message.pose.pose.orientation.w = message.pose.pose.orientation.z = std::sqrt(0.5);
  const Eigen::Isometry3d T_map_body = to_pose(message);
  const auto scan_of = [&](CloudFrame frame, const Eigen::Vector3d& point) {
    options.cloud_frame = frame;
    ScanPairing pairing(options);
    pairing.add_odometry(message);
    pairing.add_cloud(make_cloud<double>({point, {0, 0, 0}}, kSecond_ns));
    return pairing.next().value();
  };
  for (const auto& paired :
       {scan_of(CloudFrame::kSensor, kPoint), scan_of(CloudFrame::kBody, options.T_body_sensor * kPoint),
        scan_of(CloudFrame::kWorld, T_map_body * options.T_body_sensor * kPoint)}) {
    EXPECT_TRUE(paired.T_map_sensor.isApprox(T_map_body * options.T_body_sensor));
    EXPECT_TRUE(paired.scan.points[0].isApprox(kPoint.cast<float>(), 1e-4f));
    EXPECT_TRUE(paired.scan.points[1].isZero(0)) << "no return stays no return";
  }
}

TEST(ScanPairing, RefusesOdometryThatIsNoPose) {
  ScanPairing pairing(PairingOptions{});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const nav_msgs::Odometry& message, const std::string& words) {
    expect_message<std::invalid_argument>([&] { pairing.add_odometry(message); }, words);
  };
  refused(odometry(kSecond_ns, nan), "not finite");
  refused(odometry(kSecond_ns, 0, 0), "length 0.000000, not 1");
  refused(odometry(kSecond_ns, 0, 3), "length 3.000000, not 1");
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns));
  EXPECT_FALSE(pairing.next()) << "a refused pose is not used";
}

TEST(ScanPairing, DropsTheOldestWhenTheQueueIsFullAndSaysWhy) {
  PairingOptions options;
  options.queue_size = 2;
  ScanPairing pairing(options);
  for (int i = 0; i < 3; ++i) pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + i * kTenth_ns));
  EXPECT_EQ(pairing.dropped().at("no_pose"), 1u);
  for (int i = 0; i < 5; ++i) pairing.add_odometry(odometry(kSecond_ns + i * kTenth_ns, i));
  for (int i = 3; i < 5; ++i) pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + i * kTenth_ns));
  EXPECT_EQ(pairing.dropped().at("queue_full"), 2u);
  EXPECT_EQ(stamps_of_all(pairing).size(), 2u);
}

TEST(ScanPairing, DropsACloudThatNoPoseSurrounds) {
  ScanPairing pairing(PairingOptions{});
  pairing.add_odometry(odometry(2 * kSecond_ns, 0));
  pairing.add_odometry(odometry(5 * kSecond_ns, 0));
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns));
  pairing.add_cloud(make_cloud({kPoint}, 3 * kSecond_ns));
  EXPECT_FALSE(pairing.next());
  EXPECT_EQ(pairing.dropped().at("no_pose"), 2u);
}

TEST(ScanPairing, DropsALateCloudAndADuplicate) {
  ScanPairing pairing(PairingOptions{});
  for (int i = 0; i < 3; ++i) pairing.add_odometry(odometry(kSecond_ns + i * kTenth_ns, i));
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + kTenth_ns));
  ASSERT_TRUE(pairing.next());
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns));
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + kTenth_ns));
  EXPECT_FALSE(pairing.next());
  EXPECT_EQ(pairing.dropped().at("late"), 2u);
}

TEST(ScanPairing, BeginsAnewWhenTheStampsJumpBack) {
  ScanPairing pairing(PairingOptions{});
  std::vector<std::string> reasons;
  pairing.set_drop_listener(
      [&](const std::string& reason, const std::string&) { reasons.push_back(reason); });
  pairing.add_odometry(odometry(100 * kSecond_ns, 1));
  pairing.add_cloud(make_cloud({kPoint}, 100 * kSecond_ns));
  ASSERT_TRUE(pairing.next());
  pairing.add_cloud(make_cloud({kPoint}, 101 * kSecond_ns));  // its pose will not come any more
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns));
  pairing.add_odometry(odometry(kSecond_ns, 7));
  const auto paired = pairing.next();
  ASSERT_TRUE(paired);
  EXPECT_EQ(paired->T_map_sensor.translation().x(), 7);
  EXPECT_EQ(reasons, std::vector<std::string>{"jumped_back"});
  EXPECT_EQ(pairing.dropped().at("jumped_back"), 1u);
}

TEST(ScanPairing, AfterAJumpBackACloudWaitsForItsPose) {
  ScanPairing pairing(PairingOptions{});
  pairing.add_odometry(odometry(100 * kSecond_ns, 0));
  pairing.add_cloud(make_cloud({kPoint}, 100 * kSecond_ns));
  ASSERT_TRUE(pairing.next());
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns));
  EXPECT_FALSE(pairing.next());
  pairing.add_odometry(odometry(kSecond_ns, 0));
  EXPECT_TRUE(pairing.next()) << "the cloud came before its pose";
}

TEST(ScanPairing, AnUnreadableCloudIsCountedAndTheNextOneComes) {
  ScanPairing pairing(PairingOptions{});
  const auto bad = make_cloud({kPoint}, kSecond_ns);
  bad->fields.clear();
  pairing.add_cloud(bad);
  pairing.add_cloud(make_cloud({kPoint}, kSecond_ns + kTenth_ns));
  for (int i = 0; i < 2; ++i) pairing.add_odometry(odometry(kSecond_ns + i * kTenth_ns, i));
  expect_message<std::runtime_error>([&] { pairing.next(); }, "no field 'x'");
  EXPECT_EQ(pairing.dropped().at("unreadable"), 1u);
  EXPECT_TRUE(pairing.next());
}

}  // namespace
}  // namespace stillmap
