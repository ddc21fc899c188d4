#include "tools/sequence_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>

#include "io/semantickitti_folder.hpp"
#if STILLMAP_WITH_ROS
#include "tools/open_bag.hpp"
#endif

namespace stillmap {

void SequenceOptions::add_to(CLI::App& command) {
  command.add_option("SEQUENCE", path, "Folder in SemanticKITTI layout, or a .bag")->required();
  add_bag_options_to(command);
}

void SequenceOptions::add_bag_options_to(CLI::App& command) {
  const std::string group = "Bags";
  command
      .add_option("--cloud-topic", cloud_topic,
                  "PointCloud2 topic; not needed when the bag has one. Several LiDARs: \"/front /rear\"")
      ->capture_default_str()
      ->group(group);
  command.add_option("--odom-topic", odom_topic, "Odometry topic; not needed when the bag has one")
      ->capture_default_str()
      ->group(group);
  command.add_option("--cloud-frame", cloud_frame, "Frame that the clouds' points are in")
      ->check(CLI::IsMember({"world", "body", "sensor"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--sensor-on-body", sensor_on_body,
                  "The sensor's place on the body that the odometry is of: x y z roll_deg pitch_deg yaw_deg, "
                  "or x y z qx qy qz qw; of several LiDARs one for each, with ; between")
      ->capture_default_str()
      ->group(group);
}

std::unique_ptr<Sequence> SequenceOptions::open() const {
  if (!std::filesystem::exists(path))
    throw std::runtime_error(path + ": no such file or folder; expected a sequence or a .bag");
  if (std::filesystem::is_directory(path)) return std::make_unique<SemanticKittiFolder>(path);
#if STILLMAP_WITH_ROS
  return open_bag(*this);
#else
  throw std::runtime_error(path +
                           ": bags need ROS, and this stillmap was built without it "
                           "(STILLMAP_WITH_ROS=OFF); give a folder in SemanticKITTI layout");
#endif
}

}  // namespace stillmap
