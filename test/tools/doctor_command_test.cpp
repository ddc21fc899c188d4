// `stillmap doctor` on bags that are, and are not, what their topics promise.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "messages/bag_writer.hpp"
#include "simulation/simulator.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

/// A drive along the street.
void record(const std::string& file, const BagTopics& topics) {
  SimulationOptions options;
  options.sensor = "vlp16";
  options.scans = 20;
  const Simulator simulator(options);
  BagWriter bag(file, topics);
  for (std::size_t k = 0; k < simulator.size(); ++k) bag.write(simulator.frame(k).frame, {});
}

/// What the command prints.
std::string doctor(const std::string& arguments) {
  const std::string command = STILLMAP_COMMAND " doctor " + arguments + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = pipe ? std::fgetc(pipe) : EOF; c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  if (pipe) pclose(pipe);
  return text;
}

void expect_words(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "no '" << words << "' in\n" << text;
}

class DoctorCommand : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const std::string bag_ = folder_.path("drive.bag");
};

TEST_F(DoctorCommand, ASoundBagGetsThePresetOfItsTopics) {
  BagTopics topics;
  topics.cloud = "/lio_sam/mapping/cloud_registered_raw";
  topics.odometry = "/lio_sam/mapping/odometry";
  record(bag_, topics);
  const std::string text = doctor(bag_);
  expect_words(text, "nothing found");
  expect_words(text, "roslaunch stillmap stillmap.launch preset:=lio_sam bag:=" + bag_ + " rviz:=true");
}

TEST_F(DoctorCommand, AFrameThatIsNotAsThePresetSaysIsMended) {
  BagTopics topics;  // FAST-LIO's, but the clouds are the sensor's
  topics.world_clouds = false;
  record(bag_, topics);
  const std::string text = doctor(bag_);
  expect_words(text, "frames: read as cloud_frame world");
  expect_words(text, "mended: /cloud_registered (sensor) with /Odometry");
  expect_words(text, "nothing found");
  expect_words(text, "preset:=fast_lio cloud_frame:=sensor bag:=");
}

TEST_F(DoctorCommand, UnknownTopicsAreTakenWhenThereIsOneOfEach) {
  BagTopics topics;
  topics.cloud = "/mine";
  topics.odometry = "/poses";
  record(bag_, topics);
  expect_words(doctor(bag_), "preset:=generic cloud_topic:=/mine odom_topic:=/poses bag:=");
}

TEST_F(DoctorCommand, RefusesAPresetThatIsNone) {
  record(bag_, {});
  expect_words(doctor(bag_ + " --preset alaom"), "alaom not in {aloam,dlio,");
}

}  // namespace
}  // namespace stillmap
