#include "doctor/simulated_scans.hpp"

#include "simulation/simulator.hpp"

namespace stillmap {
namespace {

/// As to_paired_scan(): the sensor's scan as it seems to be.
Scan as_read(const std::vector<Eigen::Vector3f>& message, const Eigen::Isometry3d& T_odom_body,
             const PairingOptions& said) {
  const Eigen::Isometry3d R(said.R_ros_odometry);
  const Eigen::Isometry3d T_map_sensor = R * T_odom_body * R.inverse() * said.T_body_sensor;
  Eigen::Isometry3d T_sensor_message = Eigen::Isometry3d::Identity();
  if (said.cloud_frame == CloudFrame::kWorld) T_sensor_message = T_map_sensor.inverse() * R;
  if (said.cloud_frame == CloudFrame::kBody) T_sensor_message = said.T_body_sensor.inverse() * R;
  Scan scan;
  for (const Eigen::Vector3f& point : message)
    scan.points.push_back((T_sensor_message * point.cast<double>()).cast<float>());
  return scan;
}

}  // namespace

std::vector<PlacedScan> simulated(const std::string& scene, const std::string& sensor, double ego_speed_mps,
                                  std::size_t scans) {
  SimulationOptions options;
  options.scene = scene;
  options.sensor = sensor;
  options.ego_speed_mps = ego_speed_mps;
  options.scans = scans;
  const Simulator simulator(options);
  std::vector<PlacedScan> placed;
  Eigen::Isometry3d T_map_world = Eigen::Isometry3d::Identity();
  for (std::size_t k = 0; k < simulator.size(); ++k) {
    Frame frame = simulator.frame(k).frame;
    if (k == 0) T_map_world = frame.T_map_sensor.inverse();  // an odometry begins at the origin
    placed.push_back({std::move(frame.scan), T_map_world * frame.T_map_sensor});
  }
  return placed;
}

std::vector<std::string> findings(const std::vector<PlacedScan>& scans, const Sent& sent,
                                  const PairingOptions& said) {
  const Eigen::Isometry3d R(sent.truth.R_ros_odometry);
  Doctor doctor(said);
  std::vector<std::string> lines;
  for (const PlacedScan& placed : scans) {
    const AsSent message = as_sent(placed.scan, placed.T_map_sensor, sent.truth);
    const Eigen::Isometry3d T_odom_body =
        sent.odometry_stands ? Eigen::Isometry3d::Identity() : message.T_odom_body;
    const Eigen::Isometry3d R_said(said.R_ros_odometry);
    const Eigen::Isometry3d T_map_sensor = R_said * T_odom_body * R_said.inverse() * said.T_body_sensor;
    for (const Finding& finding : doctor.add(as_read(message.points, T_odom_body, said), T_map_sensor, {}))
      lines.push_back(finding.check + ": " + finding.text);
  }
  return lines;
}

}  // namespace stillmap
