// What the launch file makes of its arguments.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "ros/package_stand_in.hpp"

namespace stillmap {
namespace {

std::string output_of(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = pipe ? std::fgetc(pipe) : EOF; c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << command;
  return text;
}
std::string parameters_of_launch(const std::string& arguments) {
  return output_of("roslaunch --dump-params stillmap stillmap.launch " + arguments);
}

TEST(LaunchFile, GivesTheNodeWhatIsNamedOnly) {
  const std::string preset_alone = parameters_of_launch("preset:=dlio");
  EXPECT_NE(preset_alone.find("/stillmap/odometry_preset: dlio"), std::string::npos) << preset_alone;
  EXPECT_EQ(preset_alone.find("_topic"), std::string::npos) << preset_alone;
  EXPECT_EQ(preset_alone.find("cloud_frame"), std::string::npos) << preset_alone;
  EXPECT_EQ(preset_alone.find("sensor_on_body"), std::string::npos) << preset_alone;
  const std::string named =
      parameters_of_launch("preset:=dlio cloud_topic:=/x odom_topic:=tf2 cloud_frame:=sensor");
  EXPECT_NE(named.find("/stillmap/cloud_topic: /x"), std::string::npos) << named;
  EXPECT_NE(named.find("/stillmap/odom_topic: ''"), std::string::npos) << named;
  EXPECT_NE(named.find("/stillmap/cloud_frame: sensor"), std::string::npos) << named;
}

TEST(LaunchFile, ShowsTheMapsFrameInRviz) {
  std::string presets, frames;
  for (const PackageConventions& package : known_packages()) {
    if (package.preset == "generic") continue;  // any frame
    presets += " " + package.preset;
    frames += package.odom_frame_id.substr(package.odom_frame_id.find_first_not_of('/')) +
              (package.loam_axes ? "_z_up" : "") + "\n";
  }
  const std::string print_frames =
      "import sys, roslaunch.config, roslaunch.xmlloader as loader\n"
      "for preset in sys.argv[2:]:\n"
      "  config = roslaunch.config.ROSLaunchConfig()\n"
      "  loader.XmlLoader().load(sys.argv[1], config, argv=['preset:=' + preset, 'rviz:=true'], "
      "verbose=False)\n"
      "  print([node.args.split(' -f ')[1] for node in config.nodes if node.name == 'rviz'][0])\n";
  EXPECT_EQ(output_of("/usr/bin/python3 -c \"" + print_frames +
                      "\" $(rospack find stillmap)/launch/stillmap.launch" + presets),
            frames);
}

}  // namespace
}  // namespace stillmap
