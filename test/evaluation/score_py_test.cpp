#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "evaluation/run_method.hpp"
#include "evaluation/stillmap_method.hpp"
#include "labelled_room.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kScans = 8;

std::uint32_t class_of_verdict(Label label) {
  return label == Label::kStatic ? 9 : label == Label::kDynamic ? 251 : 0;
}

/// Compares with the scoring script that lies beside the repository.
TEST(ScorePy, GivesTheSameFigures) {
  const std::string script = PROJECT_FOLDER "/../shared/tools/score.py";
  if (!std::filesystem::exists(script)) GTEST_SKIP() << script << " is not there";
  TemporaryFolder room, out;
  write_labelled_room(room, kScans);

  LabelledFolder sequence(room.path());
  StillmapMethod method{Parameters()};
  PassScore pass;
  for (std::size_t k = 0; k < kScans; ++k) {
    const LabelledFrame scan = sequence.read(k);
    const PointVerdicts verdicts = *method.add(scan.frame);
    pass.add(scan.frame, scan.labels_now, verdicts);
    std::string bytes;
    for (const Label label : verdicts.label) {
      const std::uint32_t value = class_of_verdict(label);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    out.write("online/" + scan.frame.name + ".label", bytes);
  }
  const std::string command =
      script + " " + room.path() + " " + out.path("online") + " --json >" + out.path("s.json");
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  const nlohmann::json theirs = nlohmann::json::parse(read_text(out.path("s.json")));

  EXPECT_EQ(pass.total().static_points(), theirs["static"].get<std::size_t>());
  EXPECT_EQ(pass.total().dynamic_points(), theirs["dynamic"].get<std::size_t>());
  EXPECT_GT(pass.total().dynamic_points(), 0u);
  for (const auto& [name, uncertain] :
       {std::pair("keepU", Uncertain::kKept), std::pair("dropU", Uncertain::kDropped)}) {
    const Figures ours = pass.total().figures(uncertain);
    EXPECT_NEAR(*ours.pr, theirs[name]["PR"].get<double>(), 1e-9);
    EXPECT_NEAR(*ours.rr, theirs[name]["RR"].get<double>(), 1e-9);
    EXPECT_NEAR(*ours.score, theirs[name]["score"].get<double>(), 1e-9);
  }
  EXPECT_NEAR(*pass.total().figures(Uncertain::kKept).iou, theirs["IoU"].get<double>(), 1e-9);
}

}  // namespace
}  // namespace stillmap
