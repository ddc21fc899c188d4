// `stillmap export`, `diff` and `merge` on the maps of two simulated sessions, and on files that are none.
#include <gtest/gtest.h>

#include "io/map_archive.hpp"
#include "maps/two_sessions.hpp"
#include "support/run_command.hpp"

namespace stillmap::simulation {
namespace {

struct MapCommandsTest : testing::Test {
  static TemporaryFolder& folder() {
    static TemporaryFolder folder;
    return folder;
  }
  const std::string before = folder().path("before.stillmap"), now = folder().path("now.stillmap");

  static void SetUpTestSuite() {
    write_map_archive(pieces_of(session({{4, -4}})), folder().path("before.stillmap"));
    write_map_archive(pieces_of(session({{7, 2}})), folder().path("now.stillmap"));
    write_map_archive(pieces_of(session({}, 0.2)), folder().path("coarse.stillmap"));
    const std::string whole = read_text(folder().path("now.stillmap"));
    folder().write("cut.stillmap", whole.substr(0, whole.size() / 2));
    folder().write("foreign.stillmap", "something else");
  }
  void expect_refused(const std::string& arguments, std::initializer_list<std::string> words) const {
    const CommandResult result = run_command(STILLMAP_EXECUTABLE, arguments);
    EXPECT_EQ(result.status, 1) << arguments;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
    for (const std::string& word : words)
      EXPECT_NE(result.output.find(word), std::string::npos)
          << "'" << word << "' is not in: " << result.output;
  }
};

TEST_F(MapCommandsTest, ExportsEveryForm) {
  std::string arguments = "export " + now;
  const std::vector<std::string> forms = {".pcd", ".ply", ".bt", ".ot", ".png", ".stillmap"};
  for (const std::string& form : forms) arguments += " " + folder().path("out" + form);
  const CommandResult result = run_command(STILLMAP_EXECUTABLE, arguments);
  ASSERT_EQ(result.status, 0) << result.output;
  for (const std::string& form : forms)
    EXPECT_GT(std::filesystem::file_size(folder().path("out" + form)), 500U) << form;
  EXPECT_EQ(read_text(folder().path("out.stillmap")), read_text(now));
  EXPECT_NE(result.output.find("yellow"), std::string::npos) << result.output;
}

TEST_F(MapCommandsTest, DiffListsBothChangesAndLeavesTheirClouds) {
  const CommandResult result =
      run_command(STILLMAP_EXECUTABLE, "diff " + before + " " + now + " --out " + folder().path("changes"));
  ASSERT_EQ(result.status, 0) << result.output;
  EXPECT_NE(result.output.find("\nappeared"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("\ngone"), std::string::npos) << result.output;
  const std::string csv = read_text(folder().path("changes/changes.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << csv;
  for (const char* file : {"appeared.pcd", "gone.pcd", "diff.png"})
    EXPECT_GT(std::filesystem::file_size(folder().path(std::string("changes/") + file)), 500U) << file;
}

TEST_F(MapCommandsTest, MergeHasTheVoxelsOfBoth) {
  const std::string out = folder().path("both.stillmap");
  const CommandResult result = run_command(STILLMAP_EXECUTABLE, "merge " + out + " " + before + " " + now);
  ASSERT_EQ(result.status, 0) << result.output;
  const auto static_in_crate = [](const MapContents& map, double x, double y) {
    std::size_t voxels = 0;
    for (const SnapshotVoxel& voxel : snapshot_of(pieces_of(map), decision_of(Parameters())).voxels) {
      const Eigen::Vector3f off = voxel.center - Eigen::Vector3f(float(x), float(y), 0.5F);
      voxels += voxel.label == Label::kStatic && off.cwiseAbs().maxCoeff() < 0.6F && voxel.center.z() > 0.2F;
    }
    return voxels;
  };
  const MapContents merged = read_map_archive(out);
  EXPECT_GT(static_in_crate(merged, 4, -4), 20U);
  EXPECT_GT(static_in_crate(merged, 7, 2), 20U);
  EXPECT_LT(static_in_crate(read_map_archive(now), 4, -4), 5U);
}

TEST_F(MapCommandsTest, ExplainsAPlaceOfAMap) {
  const CommandResult result = run_command(
      STILLMAP_EXECUTABLE, "explain " + now + " --at '7 1.55 0.6' --picture " + folder().path("why.png"));
  ASSERT_EQ(result.status, 0) << result.output;
  EXPECT_EQ(result.output.find("(7.00, 1.55, 0.60): static, p_static 0."), 0U) << result.output;
  EXPECT_NE(result.output.find("None of the kept scans"), std::string::npos) << result.output;
  EXPECT_GT(std::filesystem::file_size(folder().path("why.png")), 500U);
}

TEST_F(MapCommandsTest, RepairForgetsAndRelabelsBoxes) {
  const std::string out = folder().path("repaired.stillmap");
  const CommandResult result =
      run_command(STILLMAP_EXECUTABLE, "repair " + now + " " + out +
                                           " --clear '6.4 1.4 0.2 7.6 2.6 1.2'"
                                           " --relabel 'dynamic 4.7 4.7 0.3 5.3 5.3 3.2'");
  ASSERT_EQ(result.status, 0) << result.output;
  const MapSnapshot before = snapshot_of(pieces_of(read_map_archive(now)), decision_of(Parameters()));
  const MapSnapshot after = snapshot_of(pieces_of(read_map_archive(out)), decision_of(Parameters()));
  const auto in = [](const MapSnapshot& map, const Eigen::AlignedBox3d& box, Label label) {
    std::size_t voxels = 0;
    for (const SnapshotVoxel& voxel : map.voxels)
      voxels += voxel.label == label && box.contains(voxel.center.cast<double>());
    return voxels;
  };
  const Eigen::AlignedBox3d crate = box({6.5, 1.5, 0.3}, {7.5, 2.5, 1.1}),
                            pole = box({4.8, 4.8, 0.4}, {5.2, 5.2, 3.1});
  EXPECT_GT(in(before, crate, Label::kStatic), 20U);
  EXPECT_EQ(in(after, crate, Label::kStatic), 0U);
  EXPECT_GT(in(before, pole, Label::kStatic), 10U);
  EXPECT_EQ(in(after, pole, Label::kStatic), 0U);
  EXPECT_GT(in(after, pole, Label::kDynamic), 10U);
  EXPECT_LT(after.voxels.size(), before.voxels.size());
}

TEST_F(MapCommandsTest, RefusesWithOneMessageAndWritesNothing) {
  const std::string out = folder().path("refused.stillmap"), coarse = folder().path("coarse.stillmap");
  for (const std::string name : {"cut.stillmap", "foreign.stillmap", "missing.stillmap"}) {
    const std::string bad = folder().path(name);
    expect_refused("export " + bad + " " + folder().path("refused.pcd"), {name});
    expect_refused("diff " + now + " " + bad, {name});
    expect_refused("merge " + out + " " + now + " " + bad, {name});
  }
  expect_refused("diff " + now + " " + coarse, {"0.1", "0.2"});
  expect_refused("merge " + out + " " + now + " " + coarse, {"coarse.stillmap", "0.1", "0.2"});
  expect_refused("export " + now + " " + folder().path("map.las"), {".las", ".pcd"});
  const std::string repair = "repair " + now + " " + out;
  expect_refused(repair, {"--clear", "--relabel"});
  expect_refused(repair + " --clear '900 0 0 901 1 1'",
                 {"no voxel is in the box; the map reaches from (-15"});
  expect_refused(repair + " --clear '1 0 0 0 1 1'", {"the box is empty"});
  expect_refused(repair + " --clear '0 0 0 1 1'", {"--clear '0 0 0 1 1'", "x y z x y z"});
  expect_refused(repair + " --relabel 'gone 0 0 0 1 1 1'", {"static, dynamic or uncertain"});
  expect_refused("repair " + coarse + "x " + out + " --clear '0 0 0 1 1 1'", {"coarse.stillmapx"});
  expect_refused("explain " + now + " --at '1 2'", {"--at '1 2': give x y z"});
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_FALSE(std::filesystem::exists(folder().path("refused.pcd")));
}

}  // namespace
}  // namespace stillmap::simulation
