#include <sys/wait.h>

#include <algorithm>

#include "evaluation/labelled_sequence.hpp"
#include "labelled_room.hpp"
#if STILLMAP_WITH_ROS
#include "messages/bag_writer.hpp"
#endif

namespace stillmap {
namespace {

constexpr std::size_t kScans = 6;

struct EvaluateCommandTest : testing::Test {
  TemporaryFolder room, out;
  std::string output;  ///< of the last run, stdout and stderr

  EvaluateCommandTest() { write_labelled_room(room, kScans); }

  int run(const std::string& arguments) {
    const std::string log = out.path("log.txt");
    const int status = std::system((STILLMAP_EXECUTABLE " " + arguments + " >" + log + " 2>&1").c_str());
    output = read_text(log);
    return WEXITSTATUS(status);
  }
  int evaluate(const std::string& arguments) {
    return run("evaluate --no-figures --out " + out.path("report") + " " + arguments);
  }
  void expect_one_message(const std::string& words) const {
    EXPECT_NE(output.find(words), std::string::npos) << "'" << words << "' is not in: " << output;
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
  }
};

TEST_F(EvaluateCommandTest, WritesAReport) {
  ASSERT_EQ(evaluate("--methods default,erasor --max-points 2000 --scans 5 " + room.path()), 0) << output;
  for (const std::string words :
       {"| default |", "| erasor |", "delayed: PR / RR / score", "calibration error"})
    EXPECT_NE(output.find(words), std::string::npos) << words << " is not in " << output;
  const std::string tables = read_text(out.path("report/tables.md"));
  EXPECT_NE(tables.find("5 scans from number 0, at most 2000 points each, seed 7"), std::string::npos)
      << tables;
  EXPECT_NE(read_text(out.path("report/conditions.md")).find("--max-points 2000"), std::string::npos);
}

TEST_F(EvaluateCommandTest, ThePapersExperimentOnWhatThereIs) {
  ASSERT_EQ(evaluate("--methods paper --semantickitti " + room.path()), 0) << output;
  const std::string tables = read_text(out.path("report/tables.md"));
  EXPECT_NE(tables.find("6 scans from number 0, at most 8000 points each"), std::string::npos) << tables;
  EXPECT_NE(tables.find("Table 2"), std::string::npos);
}

TEST_F(EvaluateCommandTest, FiguresAndAPageThatHoldsThem) {
  if (std::system("/usr/bin/python3 -c 'import matplotlib, numpy' 2>/dev/null") != 0)
    GTEST_SKIP() << "python3-matplotlib is not there";
  const std::string arguments = " --methods default --scans 3 --max-points 500 --out ";
  ASSERT_EQ(run("evaluate " + room.path() + arguments + out.path("report")), 0) << output;
  const std::string page = read_text(out.path("report/index.html"));
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(page.find("src=\"figures"), std::string::npos);
  std::size_t figures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out.path("report/figures")))
    figures += entry.path().extension() == ".png";
  EXPECT_EQ(figures, 3u);  // before and after, thresholds, calibration
}

TEST_F(EvaluateCommandTest, AblationOverAFolderOfSequences) {
  TemporaryFolder all;
  std::filesystem::create_symlink(room.path(), all.path("one"));
  std::filesystem::create_symlink(room.path(), all.path("two"));
  ASSERT_EQ(evaluate("--ablation --brief --scans 3 --max-points 1000 " + all.path()), 0) << output;
  for (const char* words : {"| one | full |", "| two | full |", "| two | no replay of earlier scans |"})
    EXPECT_NE(output.find(words), std::string::npos) << words << " is not in " << output;
}

TEST_F(EvaluateCommandTest, InjectMakesASequenceToEvaluate) {
  ASSERT_EQ(run("inject " + room.path() + " " + out.path("injected") +
                " --from 0 --scans 4 --vehicles 0 --people 1 --person-points 50"),
            0)
      << output;
  LabelledFolder injected(out.path("injected"));
  EXPECT_EQ(injected.size(), 4u);
  ASSERT_EQ(evaluate("--methods default --treescope " + out.path("injected")), 0) << output;
  EXPECT_NE(read_text(out.path("report/tables.md")).find("Table 3"), std::string::npos);
}

TEST_F(EvaluateCommandTest, BrokenInputGetsOneMessage) {
  EXPECT_EQ(evaluate(""), 1);
  expect_one_message("nothing to evaluate");
  EXPECT_EQ(evaluate("/no/such/folder"), 1);
  expect_one_message("/no/such/folder: no such folder");
  EXPECT_EQ(evaluate(room.path() + " " + room.path()), 1);
  expect_one_message("two sequences are called");
  room.write("labels/000004.label", "1234");
  EXPECT_EQ(evaluate("--methods default " + room.path()), 1);
  expect_one_message("000004.label: 4 bytes");
  room.write("velodyne/000002.bin", "cut off");
  EXPECT_EQ(evaluate("--methods default " + room.path()), 1);
  expect_one_message("000002.bin: 7 bytes");
  std::filesystem::remove(room.path("poses.txt"));
  EXPECT_EQ(evaluate("--methods default " + room.path()), 1);
  expect_one_message("poses.txt: cannot be read");
  EXPECT_GT(evaluate("--methods dufomap " + room.path()), 1);
}

#if STILLMAP_WITH_ROS
TEST_F(EvaluateCommandTest, ABagLaidOutAsTreeScopeGetsTargets) {
  BagTopics topics;
  topics.cloud = "/os_node/segmented_point_cloud_no_destagger";
  topics.world_clouds = false;
  {
    BagWriter bag(out.path("orchard.bag"), topics);
    for (std::size_t k = 0; k < 14; ++k) bag.write(room_frame(k), {});
  }
  ASSERT_EQ(evaluate("--methods default --treescope " + out.path("orchard.bag")), 0) << output;
  const std::string tables = read_text(out.path("report/tables.md"));
  EXPECT_NE(tables.find("4 scans from number 10, at most 9000 points each"), std::string::npos) << tables;
  EXPECT_NE(tables.find("with targets put in"), std::string::npos);
}

TEST_F(EvaluateCommandTest, ABagWithoutTheTopicIsRefused) {
  {
    BagWriter bag(out.path("other.bag"));
    bag.write(room_frame(0), {});
  }
  EXPECT_EQ(evaluate("--treescope " + out.path("other.bag")), 1);
  expect_one_message("/os_node/segmented_point_cloud_no_destagger");
}
#endif

}  // namespace
}  // namespace stillmap
