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
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_FALSE(std::filesystem::exists(folder().path("refused.pcd")));
}

}  // namespace
}  // namespace stillmap::simulation
