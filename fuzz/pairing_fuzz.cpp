// Clouds and poses in any order, with any stamps, also not finite: each cloud is answered, dropped or waits.

#include <boost/make_shared.hpp>
#include <cmath>

#include "expect.hpp"
#include "input.hpp"
#include "messages/scan_pairing.hpp"

namespace stillmap::fuzz {
namespace {

std_msgs::Header take_header(Input& in) {
  std_msgs::Header header;
  const auto tenths = in.take<std::uint8_t>();
  header.stamp.fromNSec(tenths < 250 ? tenths * 100'000'000ULL : in.take<std::uint32_t>() * 1'000'000'000ULL);
  return header;
}

double take_number(Input& in) {
  const auto tenths = in.take<std::int8_t>();
  return tenths > -120 ? tenths / 10.0 : in.take<double>();
}

nav_msgs::Odometry take_odometry(Input& in) {
  nav_msgs::Odometry odometry;
  odometry.header = take_header(in);
  auto& pose = odometry.pose.pose;
  pose.orientation.w = 1;
  if (in.choose(4) == 0)
    for (double* number :
         {&pose.orientation.x, &pose.orientation.y, &pose.orientation.z, &pose.orientation.w})
      *number = take_number(in);
  for (double* number : {&pose.position.x, &pose.position.y, &pose.position.z}) *number = take_number(in);
  return odometry;
}

sensor_msgs::PointCloud2ConstPtr take_small_cloud(Input& in) {
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = take_header(in);
  cloud->width = static_cast<std::uint32_t>(in.choose(3));
  cloud->height = 1;
  cloud->point_step = 12;
  cloud->row_step = cloud->width * 12;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField& field = cloud->fields.emplace_back();
    field.name = name;
    field.offset = static_cast<std::uint32_t>(4 * (cloud->fields.size() - 1));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
  }
  cloud->data.resize(in.choose(8) == 0 ? in.choose(40) : cloud->row_step, 0x3F);
  return cloud;
}

std::size_t dropped(const ScanPairing& pairing) {
  std::size_t clouds = 0;
  for (const auto& [reason, count] : pairing.dropped()) clouds += count;
  return clouds;
}

/// Takes what is ready, up to a cloud that cannot be read.
std::size_t take_ready(ScanPairing& pairing) {
  std::size_t answered = 0;
  expect_named_refusal("", [&] {
    while (const std::optional<PairedScan> paired = pairing.next()) {
      ++answered;
      expect(paired->T_map_sensor.matrix().allFinite(), "a scan's pose is finite");
    }
  });
  return answered;
}

void run(Input& in) {
  PairingOptions options;
  options.cloud_frame = static_cast<CloudFrame>(in.choose(3));
  options.queue_size = 1 + in.choose(5);
  options.R_ros_odometry = parse_odometry_axes(in.choose(2) ? "loam" : "ros");
  ScanPairing pairing(options);
  std::size_t given = 0, answered = 0;
  while (!in.empty()) {
    switch (in.choose(3)) {
      case 0:
        pairing.add_cloud(take_small_cloud(in));
        ++given;
        break;
      case 1:
        expect_named_refusal("", [&] { pairing.add_odometry(take_odometry(in)); });
        break;
      default:
        answered += take_ready(pairing);
    }
    expect(pairing.waiting() <= options.queue_size, "no more clouds wait than may");
    expect(given == answered + dropped(pairing) + pairing.waiting(), "no cloud is lost from the books");
  }
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stillmap::fuzz::Input in(data, size);
  stillmap::fuzz::run(in);
  return 0;
}
