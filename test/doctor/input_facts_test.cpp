#include "doctor/input_facts.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

TEST(InputFacts, SoundInputIsLeftInPeace) {
  InputFacts facts;
  EXPECT_TRUE(check_input(facts).empty());
  facts.clouds = 20;
  facts.answered = 18;  // the last two still wait
  EXPECT_TRUE(check_input(facts).empty());
  facts = {};
  facts.clouds = 5;  // too early to say
  EXPECT_TRUE(check_input(facts).empty());
}

TEST(InputFacts, StampsThatDoNotPair) {
  InputFacts facts;
  facts.clouds = 20;
  facts.answered = 1;
  facts.why_not = "the newest odometry is 3600.0 s older than the cloud";
  const std::vector<Finding> found = check_input(facts);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].check, "stamps");
  EXPECT_EQ(found[0].text.rfind("19 of 20 clouds have no pose: the newest odometry is 3600.0 s older", 0),
            0u);
  EXPECT_NE(found[0].text.find("set odom_topic"), std::string::npos);
}

TEST(InputFacts, FramesThatTfDoesNotKnow) {
  InputFacts facts;
  facts.clouds = 20;
  facts.uses_tf = true;
  facts.needed_frames = {"odom", "lidar"};
  facts.tf_frames = {"odom", "base_link"};
  const std::vector<Finding> found = check_input(facts);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].check, "tf");
  EXPECT_EQ(found[0].text.rfind("tf2 does not know the frame lidar (it knows odom, base_link)", 0), 0u);
  EXPECT_EQ(found[1].check, "stamps");
}

TEST(InputFacts, AClockThatStands) {
  InputFacts facts;
  facts.clock_stands = true;
  const std::vector<Finding> found = check_input(facts);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].check, "clock");
  EXPECT_NE(found[0].text.find("--clock"), std::string::npos);
}

}  // namespace
}  // namespace stillmap
