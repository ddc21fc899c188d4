#include "doctor/input_facts.hpp"

#include <algorithm>

namespace stillmap {
namespace {

constexpr std::size_t kEnough = 10;

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace

std::vector<Finding> check_input(const InputFacts& facts) {
  std::vector<Finding> findings;
  if (facts.clock_stands)
    findings.push_back(
        {"clock",
         "use_sim_time is true, but nobody sends /clock: play the recording with --clock, or `rosparam "
         "set use_sim_time false`"});
  if (facts.clouds < kEnough || 2 * facts.answered >= facts.clouds) return findings;
  const auto is_unknown = [&](const std::string& frame) {
    return std::find(facts.tf_frames.begin(), facts.tf_frames.end(), frame) == facts.tf_frames.end();
  };
  for (const std::string& frame : facts.needed_frames)
    if (facts.uses_tf && is_unknown(frame))
      findings.push_back({"tf", "tf2 does not know the frame " + frame + " (it knows " +
                                    list(facts.tf_frames) +
                                    "): set fixed_frame and body_frame to frames that it knows"});
  const std::string seen = std::to_string(facts.clouds - facts.answered) + " of " +
                           std::to_string(facts.clouds) + " clouds have no pose: " + facts.why_not;
  findings.push_back(
      {"stamps",
       seen + (facts.uses_tf ? "; check that tf2 and the clouds have one clock"
                             : "; set odom_topic to the odometry of this sensor and clock, or raise "
                               "max_odometry_gap_s")});
  return findings;
}

}  // namespace stillmap
