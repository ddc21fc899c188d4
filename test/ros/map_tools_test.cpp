// Asking the map, repairing it, going on with an earlier one, and following a corrected path.

#include <geometry_msgs/PointStamped.h>
#include <nav_msgs/Path.h>
#include <ros/init.h>
#include <stillmap/ClearBox.h>
#include <stillmap/DiffMap.h>
#include <stillmap/LoadMap.h>
#include <stillmap/RelabelBox.h>
#include <stillmap/SaveMap.h>
#include <visualization_msgs/MarkerArray.h>

#include "io/map_archive.hpp"
#include "ros/map_tools.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

TEST_F(MapTools, ExplainsAPlaceInNumbersWordsAndMarkers) {
  const ExplainPoint::Response told = explain(point(4.99, 0.04, 0.1));
  EXPECT_TRUE(told.success && told.in_map) << told.message;
  EXPECT_EQ(told.label, 1);
  EXPECT_GT(told.p_static, 0.8);
  EXPECT_EQ(told.evidence, "support");
  EXPECT_EQ(told.stamp, room_odometry(newest_ - 1).header.stamp);
  EXPECT_NEAR(told.difference_m, 0, 0.2);
  const auto markers = latched<visualization_msgs::MarkerArray>("/stillmap/explanation");
  ASSERT_TRUE(markers);
  ASSERT_EQ(markers->markers.size(), 3u);
  EXPECT_EQ(markers->markers[0].header.frame_id, "camera_init");
  EXPECT_NEAR(markers->markers[0].pose.position.x, 5, 0.1);
  EXPECT_NE(markers->markers[1].text.find("static"), std::string::npos);
  EXPECT_GE(markers->markers[2].points.size(), 2u);
  EXPECT_FALSE(explain(point(0, 0, std::nan(""))).success);
}

TEST_F(MapTools, AClickedPointIsExplainedUnlessItIsInAnotherFrame) {
  ros::Publisher clicks = ros::NodeHandle().advertise<geometry_msgs::PointStamped>("/clicked_point", 1, true);
  geometry_msgs::PointStamped click;
  click.header.frame_id = "camera_init";
  click.point = point(-4.99, 0.04, 0.1);
  clicks.publish(click);
  EXPECT_TRUE(harness().said("explain_point: (-4.99, 0.04, 0.10): static"));
  click.header.frame_id = "map";
  clicks.publish(click);
  EXPECT_TRUE(harness().said("the point is in frame 'map' and the map in 'camera_init'"));
}

TEST_F(MapTools, BoxesAreClearedAndRelabelled) {
  auto relabel = wall_box<RelabelBox>();
  relabel.label = 2;
  const RelabelBox::Response relabelled = call<RelabelBox>("relabel_box", relabel);
  EXPECT_TRUE(relabelled.success && relabelled.voxels > 10) << relabelled.message;
  EXPECT_EQ(explain(point(4.99, 0.04, 0.1)).label, 2);
  relabel.label = 3;
  EXPECT_NE(call<RelabelBox>("relabel_box", relabel).message.find("give 0"), std::string::npos);

  const ClearBox::Response cleared = call<ClearBox>("clear_box", wall_box<ClearBox>());
  EXPECT_TRUE(cleared.success);
  EXPECT_EQ(cleared.voxels, relabelled.voxels);
  EXPECT_FALSE(explain(point(4.99, 0.04, 0.1)).in_map);
  const ClearBox::Response outside = call<ClearBox>("clear_box", wall_box<ClearBox>(500));
  EXPECT_FALSE(outside.success);
  EXPECT_NE(outside.message.find("no voxel is in the box; the map reaches from (-"), std::string::npos)
      << outside.message;
}

TEST_F(MapTools, GoesOnWithAnEarlierMapAndSaysWhatIsDifferent) {
  const TemporaryFolder folder;
  const std::string file = folder.path("room.stillmap");
  ASSERT_TRUE(call_with_path<SaveMap>("save_map", file).success);
  ASSERT_TRUE(call<ClearBox>("clear_box", wall_box<ClearBox>()).success);
  const DiffMap::Response difference = call_with_path<DiffMap>("diff_map", file);
  EXPECT_TRUE(difference.success) << difference.message;
  EXPECT_EQ(difference.gone, 1u) << difference.message;
  EXPECT_EQ(difference.appeared, 0u) << difference.message;
  const auto gone = latched<sensor_msgs::PointCloud2>("/stillmap/gone");
  ASSERT_TRUE(gone);
  EXPECT_GT(gone->width, 10u);

  const std::string whole = read_text(file), coarse = folder.path("coarse.stillmap");
  write_map_archive(pieces_of({0, 0.2, {}}), coarse);
  for (const std::string& bad :
       {folder.write("foreign.stillmap", "no map"), folder.write("cut.stillmap", whole.substr(0, 500)),
        coarse, folder.path("none.stillmap")}) {
    const LoadMap::Response refused = call_with_path<LoadMap>("load_map", bad);
    EXPECT_FALSE(refused.success);
    EXPECT_NE(refused.message.find(bad), std::string::npos) << refused.message;
    EXPECT_FALSE(call_with_path<DiffMap>("diff_map", bad).success);
    EXPECT_TRUE(explain(point(-4.99, 0.04, 0.1)).in_map) << "the map stays as it was";
  }
  EXPECT_NE(call_with_path<LoadMap>("load_map", coarse).message.find("voxel_size_m is 0.1"),
            std::string::npos);
  const LoadMap::Response loaded = call_with_path<LoadMap>("load_map", file);
  EXPECT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(explain(point(4.99, 0.04, 0.1)).label, 1);
  EXPECT_TRUE(scan());
}

TEST_F(MapTools, FollowsACorrectedPath) {
  ros::Publisher paths = ros::NodeHandle().advertise<nav_msgs::Path>("/corrected_path", 1);
  ASSERT_TRUE(harness().wait_until([&] { return paths.getNumSubscribers() > 0; }));
  nav_msgs::Path path;
  path.header.frame_id = "/camera_init";
  for (int k = newest_ - 8; k < newest_; ++k) {
    geometry_msgs::PoseStamped pose;
    pose.header = room_odometry(k).header;
    pose.pose = room_odometry(k).pose.pose;
    pose.pose.position.y += 3;
    path.poses.push_back(pose);
  }
  const auto publish = [&](const nav_msgs::Path& what, const std::string& answer) {
    harness().forget_what_was_said();
    paths.publish(what);
    harness().wait_until([&] { return scan() && harness().said(answer, 0.2); });
    EXPECT_TRUE(harness().said(answer, 0.2)) << answer;
  };
  nav_msgs::Path elsewhere = path, foreign = path;
  elsewhere.header.frame_id = "map";
  publish(elsewhere, "the path is in frame 'map' and the map in 'camera_init'");
  for (geometry_msgs::PoseStamped& pose : foreign.poses) pose.header.stamp += ros::Duration(1000);
  publish(foreign, "/corrected_path: not used, the map stays as it is: the corrected path has 8 poses");
  EXPECT_TRUE(explain(point(4.99, -4.5, 0.1)).in_map) << "the map stays as it was";
  publish(path, "/corrected_path: the map follows the corrected trajectory, 1 submaps, the farthest by 3 m");
  EXPECT_TRUE(explain(point(0.04, 7.99, 0.1)).in_map) << "the wall that stood at 5 m";
}

TEST_F(MapTools, NothingMovesSoThereAreNoBoxes) {
  std::size_t arrays = 0, boxes = 0;
  const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> count =
      [&](const visualization_msgs::MarkerArrayConstPtr& array) {
        ++arrays;
        boxes += array->markers.size();
      };
  const ros::Subscriber subscriber =
      ros::NodeHandle().subscribe<visualization_msgs::MarkerArray>("/stillmap/moving_boxes", 10, count);
  EXPECT_TRUE(harness().wait_until([&] { return scan() && arrays > 0; }));
  EXPECT_EQ(boxes, 0u);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_tools_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
