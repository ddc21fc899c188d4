#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "io/semantickitti_folder.hpp"
#include "stillmap/mapper.hpp"
#include "support/temporary_folder.hpp"
#include "tools/room_sequence.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kScans = 8;

std::uint32_t class_of(Label label) {
  return label == Label::kStatic ? 9 : label == Label::kDynamic ? 251 : 0;
}

std::vector<std::uint32_t> classes_of(const ScanLabels& labels) {
  std::vector<std::uint32_t> classes;
  for (const Label label : labels.label) classes.push_back(class_of(label));
  return classes;
}

struct LabelCommandTest : testing::Test {
  TemporaryFolder room, out;
  std::string output;  ///< of the last run, stdout and stderr

  LabelCommandTest() { write_room_sequence(room, kScans); }

  int run(const std::string& arguments) {
    const std::string log = out.path("log.txt");
    const int status = std::system((STILLMAP_EXECUTABLE " " + arguments + " >" + log + " 2>&1").c_str());
    output = read_text(log);
    return WEXITSTATUS(status);
  }
  int label(const std::string& options = "", const std::string& sequence = "") {
    return run("label " + (sequence.empty() ? room.path() : sequence) + " " + out.path("o") + " " + options);
  }
  std::vector<std::uint32_t> labels(const std::string& pass, const std::string& name) const {
    return read_labels(out.path("o/" + pass + "/" + name + ".label"), room_frame(0).scan.points.size());
  }
  std::size_t files(const std::string& pass) const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(out.path("o/" + pass)))
      count += entry.exists();
    return count;
  }
  nlohmann::json summary() const { return nlohmann::json::parse(read_text(out.path("o/summary.json"))); }
  void expect_output(const std::string& words) const {
    EXPECT_NE(output.find(words), std::string::npos) << "'" << words << "' is not in: " << output;
  }
};

TEST_F(LabelCommandTest, LabelsAreTheMappersAtOnceAndAtTheEnd) {
  ASSERT_EQ(label(), 0) << output;
  EXPECT_EQ(output, "");  // the progress bar is for terminals
  Mapper mapper{Parameters()};
  std::vector<ScanLabels> online;
  for (std::size_t k = 0; k < kScans; ++k) {
    const Frame frame = room_frame(k);
    online.push_back(mapper.process(frame.scan, frame.T_map_sensor));
    EXPECT_EQ(labels("online", frame.name), classes_of(online.back())) << k;
  }
  for (std::size_t k = 0; k < kScans; ++k) {
    const Frame frame = room_frame(k);
    const ScanLabels final = mapper.relabel(frame.scan, frame.T_map_sensor, online[k]);
    EXPECT_EQ(labels("final", frame.name), classes_of(final)) << k;
  }
}

TEST_F(LabelCommandTest, DelayedLabelsAreTheMappersSoManyScansLater) {
  ASSERT_EQ(label("--delay 3"), 0) << output;
  Mapper mapper{Parameters()};
  std::vector<ScanLabels> online;
  for (std::size_t k = 0; k < kScans; ++k) {
    const Frame now = room_frame(k);
    online.push_back(mapper.process(now.scan, now.T_map_sensor));
    const bool is_last = k + 1 == kScans;  // settles the rest, too
    for (std::size_t then = k < 3 ? 0 : k - 3; then <= k; ++then) {
      if (then + 3 != k && !is_last) continue;
      const Frame frame = room_frame(then);
      const ScanLabels settled = mapper.relabel(frame.scan, frame.T_map_sensor, online[then]);
      EXPECT_EQ(labels("delayed", frame.name), classes_of(settled)) << then;
    }
  }
  EXPECT_EQ(files("delayed"), kScans);
  EXPECT_EQ(summary()["labels"]["delayed"]["invalid"], 2 * kScans);
  ASSERT_EQ(label(), 0) << output;  // without: what the run before left is gone
  EXPECT_EQ(files("delayed"), 0u);
}

TEST_F(LabelCommandTest, SummaryHoldsResultsAndConditions) {
  ASSERT_EQ(label("--set voxel_size_m=0.2 --threads 2"), 0) << output;
  const nlohmann::json json = summary();
  const std::size_t points = kScans * room_frame(0).scan.points.size();
  EXPECT_EQ(json["scans"], kScans);
  EXPECT_EQ(json["points"], points);
  EXPECT_GT(json["voxels"], 0);
  EXPECT_GT(json["peak_rss_mb"], 0);
  for (const char* time : {"cpu_ms", "wall_ms"}) {
    for (const char* key : {"mean", "p50", "p95", "p99", "max"}) EXPECT_GT(json[time][key], 0) << time << key;
    EXPECT_LE(json[time]["p50"], json[time]["p95"]);
    EXPECT_LE(json[time]["p99"], json[time]["max"]);
    const double until_labels = json["until_labels"][time]["mean"], upkeep = json["upkeep"][time]["mean"];
    EXPECT_GT(until_labels, 0);
    EXPECT_GT(upkeep, 0);
    EXPECT_LE(until_labels + upkeep, json[time]["mean"].get<double>() * 1.001);  // rounded sums
  }
  EXPECT_EQ(json["stage_cpu_ms"].size(), std::size_t{kStageCount});
  EXPECT_EQ(json["parameters"]["voxel_size_m"], 0.2);
  EXPECT_EQ(json["parameters"]["threads"], 2);
  EXPECT_FALSE(json["version"].get<std::string>().empty());
  EXPECT_FALSE(json["git_revision"].get<std::string>().empty());
  for (const char* pass : {"online", "final"}) {
    std::size_t sum = 0;
    for (const auto& [label, count] : json["labels"][pass].items()) sum += count.get<std::size_t>();
    EXPECT_EQ(sum, points) << pass;
    EXPECT_GT(json["labels"][pass]["static"], 0);
    EXPECT_GT(json["labels"][pass]["dynamic"], 0);
  }
  EXPECT_TRUE(std::filesystem::exists(out.path("o/static_map.pcd")));
}

TEST_F(LabelCommandTest, APartOfTheSequenceAndNothingOfAnEarlierRun) {
  ASSERT_EQ(label(), 0) << output;
  EXPECT_EQ(files("online"), kScans);
  ASSERT_EQ(label("--from 1 --stride 2 --scans 3 --no-final"), 0) << output;
  EXPECT_EQ(files("online"), 3u);
  EXPECT_EQ(files("final"), 0u);
  for (const char* name : {"000001", "000003", "000005"}) labels("online", name);
  EXPECT_FALSE(summary()["labels"].contains("final"));
}

TEST_F(LabelCommandTest, TakesParametersFromAFileAndOverIt) {
  const std::string config = room.write("p.yaml", "voxel_size_m: 0.3\nforgetting: 0.01\n");
  ASSERT_EQ(label("--config " + config + " --set forgetting=0.02"), 0) << output;
  EXPECT_EQ(summary()["parameters"]["voxel_size_m"], 0.3);
  EXPECT_EQ(summary()["parameters"]["forgetting"], 0.02);
}

TEST_F(LabelCommandTest, RefusesBadInputInOneLine) {
  EXPECT_EQ(label("", "/no/such/folder"), 1);
  expect_output("stillmap: /no/such/folder: no such file or folder");
  EXPECT_EQ(label("--set voxel_sise_m=1"), 1);
  expect_output("stillmap: voxel_sise_m: unknown parameter; did you mean voxel_size_m?");
  EXPECT_EQ(label("--set voxel_size_m=7"), 1);
  expect_output("voxel_size_m: 7 is not in [0.02, 2] m");
  EXPECT_EQ(label("--set voxel_size_m"), 1);
  expect_output("expected name=value");
  EXPECT_EQ(label("--from 100"), 1);
  expect_output("only 8 scans");
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
}

TEST_F(LabelCommandTest, ABrokenScanLeavesNoSummary) {
  ASSERT_EQ(label(), 0) << output;
  room.write("velodyne/000003.bin", "cut off");
  EXPECT_EQ(label(), 1);
  expect_output("000003.bin: 7 bytes");
  EXPECT_FALSE(std::filesystem::exists(out.path("o/summary.json")));
}

TEST_F(LabelCommandTest, UsageErrorsAreToldApart) {
  EXPECT_GT(run(""), 1);
  EXPECT_GT(run("label " + room.path()), 1);
  expect_output("OUT");
  EXPECT_GT(label("--stride 0"), 1);
  EXPECT_GT(label("--preset paper --config x.yaml"), 1);
  EXPECT_GT(label("--cloud-frame moon"), 1);
  expect_output("--cloud-frame");
}

TEST_F(LabelCommandTest, VersionAndParametersArePrinted) {
  EXPECT_EQ(run("--version"), 0);
  expect_output("stillmap 0.");
  EXPECT_EQ(run("parameters --preset paper"), 0);
  const std::string config = room.write("paper.yaml", output);
  ASSERT_EQ(label("--scans 1 --config " + config), 0) << output;
  const nlohmann::json from_file = summary()["parameters"];
  ASSERT_EQ(label("--scans 1 --preset paper"), 0) << output;
  EXPECT_EQ(summary()["parameters"], from_file);
}

#if STILLMAP_WITH_ROS
TEST_F(LabelCommandTest, ABagGivesTheLabelsOfTheFolder) {
  ASSERT_EQ(label(), 0) << output;
  std::map<std::string, std::vector<std::uint32_t>> expected;
  for (std::size_t k = 0; k < kScans; ++k)
    for (const std::string pass : {"online", "final"})
      expected[pass + room_frame(k).name] = labels(pass, room_frame(k).name);
  ASSERT_EQ(run("bag " + room.path() + " " + room.path("room.bag") + " --frame sensor"), 0) << output;
  ASSERT_EQ(label("--cloud-frame sensor", room.path("room.bag")), 0) << output;
  for (std::size_t k = 0; k < kScans; ++k)
    for (const std::string pass : {"online", "final"})
      EXPECT_EQ(labels(pass, room_frame(k).name), expected[pass + room_frame(k).name]) << pass << k;
}
#else
TEST_F(LabelCommandTest, RefusesBagsWithoutRos) {
  EXPECT_EQ(label("", room.write("room.bag", "#ROSBAG V2.0\n")), 1);
  expect_output("bags need ROS");
}
#endif

}  // namespace
}  // namespace stillmap
