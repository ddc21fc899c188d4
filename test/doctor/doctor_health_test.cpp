// Sound set-ups of every kind of sensor and place: the doctor must say nothing.

#include <gtest/gtest.h>

#include "doctor/simulated_scans.hpp"

namespace stillmap {
namespace {

struct Place {
  const char* scene;
  const char* sensor;
  double ego_speed_mps;
};

class Health : public testing::TestWithParam<Place> {};

PairingOptions told(CloudFrame frame, const std::string& sensor_on_body, const std::string& axes = "ros") {
  PairingOptions options;
  options.cloud_frame = frame;
  options.T_body_sensor = parse_sensor_on_body(sensor_on_body);
  options.R_ros_odometry = parse_odometry_axes(axes);
  return options;
}

TEST_P(Health, IsLeftInPeace) {
  const Place& place = GetParam();
  const std::vector<PlacedScan> scans = simulated(place.scene, place.sensor, place.ego_speed_mps);
  for (const PairingOptions& options :
       {told(CloudFrame::kWorld, "0 0 0 0 0 0"), told(CloudFrame::kSensor, "0.3 0 1 0 0 90"),
        told(CloudFrame::kBody, "0.05 0 0.28 0 0 0"), told(CloudFrame::kWorld, "0 0 0 0 0 0", "loam")})
    for (const std::string& line : findings(scans, {options}, options)) ADD_FAILURE() << line;
}

INSTANTIATE_TEST_SUITE_P(Places, Health,
                         testing::Values(Place{"street", "vlp16", 4}, Place{"orchard", "os1_64", 1},
                                         Place{"plaza", "vlp16", 0}, Place{"wood", "livox", 1},
                                         Place{"rooms", "vlp16", 0.8}, Place{"highway", "hdl32", 25},
                                         Place{"carpark", "hdl32", 3}, Place{"plaza", "mid360", 0.5}),
                         [](const auto& info) {
                           return std::string(info.param.scene) + "_" + info.param.sensor;
                         });

}  // namespace
}  // namespace stillmap
