#include "evaluation/report.hpp"

#include <gtest/gtest.h>

#include "evaluation/ablation.hpp"
#include "evaluation/text_table.hpp"
#include "labelled_room.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

std::vector<SequenceResult> evaluate_room(const TemporaryFolder& room,
                                          const std::vector<std::string>& methods,
                                          std::size_t max_points = 1000) {
  SequenceResult result;
  result.name = "room";
  result.run = "6 scans";
  result.paper = PaperExperiment::semantic_kitti();
  for (const std::string& name : methods) {
    PartOptions part;
    part.max_points = max_points;
    SequencePart sequence(std::make_unique<LabelledFolder>(room.path()), part);
    RunOptions options;
    options.picture_points = 1000;
    result.methods.push_back(run_method(sequence, choose_method(name, Parameters()), options, [] {}));
  }
  return {result};
}

struct ReportTest : testing::Test {
  TemporaryFolder room, out;
  ReportTest() { write_labelled_room(room, 6); }
};

TEST_F(ReportTest, TheSameInputGivesTheSameBytes) {
  for (const char* folder : {"one", "two"})
    write_report(out.path(folder), evaluate_room(room, method_names()), {});
  for (const char* file :
       {"tables.md", "scores.csv", "classes.csv", "ranges.csv", "objects.csv", "scans.csv", "thresholds.csv",
        "calibration.csv", "settings/paper.yaml", "points/room.erasor.csv"})
    EXPECT_EQ(read_text(out.path(std::string("one/") + file)),
              read_text(out.path(std::string("two/") + file)))
        << file;
}

TEST_F(ReportTest, HoldsEveryMethodAndThePapersFigures) {
  write_report(out.path(), evaluate_room(room, method_names()), {{"seed", "7"}});
  const std::string tables = read_text(out.path("tables.md"));
  for (const std::string& method : method_names()) {
    EXPECT_NE(tables.find("| room | " + method + " |"), std::string::npos) << method;
    EXPECT_TRUE(std::filesystem::exists(out.path("settings/" + method + ".yaml"))) << method;
  }
  EXPECT_NE(tables.find("| 94.28 | 71.50 | 81.32 |"), std::string::npos);
  EXPECT_NE(tables.find("the preset `paper`"), std::string::npos);
  EXPECT_NE(tables.find("Delayed:\n"), std::string::npos);
  const std::string scores = read_text(out.path("scores.csv"));
  EXPECT_NE(scores.find(",default,delayed,"), std::string::npos);
  EXPECT_EQ(scores.find(",erasor,delayed,"), std::string::npos) << "it judges finished maps only";
  EXPECT_NE(read_text(out.path("conditions.md")).find("| seed | 7 |"), std::string::npos);
  EXPECT_NE(read_text(out.path("classes.csv")).find("moving person"), std::string::npos);
  const std::string points = read_text(out.path("points/room.default.csv"));
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 1001);
}

TEST_F(ReportTest, WithoutMovingThingsFiguresAreNotDefined) {
  for (int k = 0; k < 6; ++k) {
    const std::size_t points = room_frame(0).scan.points.size();
    const std::vector<std::uint32_t> labels(points, 50);
    room.write("labels/00000" + std::to_string(k) + ".label",
               {reinterpret_cast<const char*>(labels.data()), points * sizeof(std::uint32_t)});
  }
  write_report(out.path(), evaluate_room(room, {"default"}), {});
  EXPECT_NE(read_text(out.path("tables.md")).find("not defined"), std::string::npos);
  EXPECT_EQ(read_text(out.path("tables.md")).find("nan"), std::string::npos);
}

TEST_F(ReportTest, MethodsDoWhatTheyAreFor) {
  const SequenceResult result = evaluate_room(room, {"default", "octomap"}, 0)[0];
  EXPECT_GT(*result.methods[0].final.total().figures(Uncertain::kKept).score, 90.0);
  EXPECT_TRUE(result.methods[0].at_once);
  EXPECT_FALSE(result.methods[0].final.probabilities().empty());
  EXPECT_FALSE(result.methods[1].at_once);
  EXPECT_TRUE(result.methods[1].final.probabilities().empty());
  EXPECT_GT(result.methods[0].cost.at_once_cpu_ms, 0);
}

TEST(Methods, UnknownNameIsRefused) {
  expect_error<std::invalid_argument>([] { choose_method("dufomap", Parameters()); }, {"dufomap", "erasor"});
}

TEST(Ablation, TakesOneThingAwayAtATime) {
  const std::vector<MethodChoice> choices = ablation_choices(Parameters());
  ASSERT_GT(choices.size(), 4u);
  EXPECT_EQ(choices[0].name, "full");
  const std::string full = choices[0].make()->settings();
  for (std::size_t i = 1; i < choices.size(); ++i)
    EXPECT_NE(choices[i].make()->settings(), full) << choices[i].name;
}

TEST(TextTable, MarkdownAndCsv) {
  TextTable table({"a", "b"});
  table.add_row({"1", "x, \"y\""});
  EXPECT_EQ(table.markdown(), "| a | b |\n|---|---|\n| 1 | x, \"y\" |\n");
  EXPECT_EQ(table.csv(), "a,b\n1,\"x, \"\"y\"\"\"\n");
  EXPECT_THROW(table.add_row({"1"}), std::logic_error);
  EXPECT_EQ(cell(std::optional<double>()), "not defined");
  EXPECT_EQ(cell(93.939), "93.94");
}

}  // namespace
}  // namespace stillmap
