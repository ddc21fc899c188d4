#include "io/map_file.hpp"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include "io/octomap_file.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

constexpr float kSize_m = 0.25F;

Eigen::Vector3f center(int x, int y, int z) {
  return (Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)).array() +
          0.5F) *
         kSize_m;
}

MapSnapshot small_map() {
  MapSnapshot map;
  map.voxel_size_m = kSize_m;
  map.voxels = {{center(0, 0, 0), 2.0F, Label::kStatic},
                {center(-5, 7, 3), 40.0F, Label::kStatic},
                {center(1, 0, 0), -1.0F, Label::kDynamic},
                {center(2, 0, 0), 0.1F, Label::kUncertain}};
  return map;
}

octomap::point3d to_octomap(const Eigen::Vector3f& point) {
  return {point.x(), point.y(), point.z()};
}

void expect_static_points(const pcl::PointCloud<pcl::PointXYZI>& cloud) {
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_EQ(cloud[0].getVector3fMap(), center(0, 0, 0));
  EXPECT_NEAR(cloud[0].intensity, 0.880797, 1e-6);  // 1 / (1 + e^-2)
  EXPECT_EQ(cloud[1].getVector3fMap(), center(-5, 7, 3));
  EXPECT_EQ(cloud[1].intensity, 1.0F);
}

TEST(MapFile, PcdHoldsTheStaticVoxels) {
  const TemporaryFolder folder;
  save_map(small_map(), folder.path("map.pcd"));
  pcl::PointCloud<pcl::PointXYZI> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.path("map.pcd"), cloud), 0);
  expect_static_points(cloud);
}

TEST(MapFile, PlyHoldsTheStaticVoxels) {
  const TemporaryFolder folder;
  save_map(small_map(), folder.path("map.ply"));
  pcl::PointCloud<pcl::PointXYZI> cloud;
  ASSERT_EQ(pcl::io::loadPLYFile(folder.path("map.ply"), cloud), 0);
  expect_static_points(cloud);
}

TEST(MapFile, AnEmptyMapIsAnEmptyFile) {
  const TemporaryFolder folder;
  MapSnapshot map;
  map.voxel_size_m = kSize_m;
  save_map(map, folder.path("map.pcd"));
  EXPECT_NE(read_text(folder.path("map.pcd")).find("\nWIDTH 0\nHEIGHT 1\n"), std::string::npos);
  save_map(map, folder.path("map.ply"));
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::PLYReader().read(folder.path("map.ply"), cloud), 0);
  EXPECT_EQ(cloud.width * cloud.height, 0u);
#if PCL_VERSION_COMPARE(>=, 1, 13, 0)  // 1.10 reads no .pcd without points
  ASSERT_EQ(pcl::PCDReader().read(folder.path("map.pcd"), cloud), 0);
  EXPECT_EQ(cloud.width * cloud.height, 0u);
#endif
  save_map(map, folder.path("map.bt"));
  EXPECT_EQ(octomap::OcTree(folder.path("map.bt")).size(), 0u);
}

TEST(MapFile, OctomapKeepsOccupiedFreeAndUnknown) {
  const TemporaryFolder folder;
  for (const std::string name : {"map.bt", "map.ot"}) {
    save_map(small_map(), folder.path(name));
    std::unique_ptr<octomap::AbstractOcTree> read;
    if (name == "map.bt")
      read = std::make_unique<octomap::OcTree>(folder.path(name));
    else
      read.reset(octomap::AbstractOcTree::read(folder.path(name)));
    const auto* tree = dynamic_cast<octomap::OcTree*>(read.get());
    ASSERT_NE(tree, nullptr) << name;
    EXPECT_DOUBLE_EQ(tree->getResolution(), kSize_m);
    EXPECT_EQ(tree->getNumLeafNodes(), 3u);
    EXPECT_TRUE(tree->isNodeOccupied(tree->search(to_octomap(center(-5, 7, 3)))));
    EXPECT_FALSE(tree->isNodeOccupied(tree->search(to_octomap(center(1, 0, 0)))));
    EXPECT_EQ(tree->search(to_octomap(center(2, 0, 0))), nullptr);
  }
}

TEST(MapFile, OctreeKeepsLogOddsWithinItsBounds) {
  const auto tree = to_octree(small_map());
  EXPECT_FLOAT_EQ(tree->search(to_octomap(center(0, 0, 0)))->getLogOdds(), 2.0F);
  EXPECT_FLOAT_EQ(tree->search(to_octomap(center(-5, 7, 3)))->getLogOdds(), tree->getClampingThresMaxLog());
  EXPECT_FLOAT_EQ(tree->search(to_octomap(center(1, 0, 0)))->getLogOdds(), -1.0F);
}

TEST(MapFile, RefusesAMapWiderThanOctomapsKeys) {
  MapSnapshot map = small_map();
  map.voxels[0].center.x() = 40000 * kSize_m;
  const TemporaryFolder folder;
  expect_error([&] { save_map(map, folder.path("map.bt")); }, {"32768 voxels", "8192", ".pcd"});
  EXPECT_FALSE(std::filesystem::exists(folder.path("map.bt")));
}

TEST(MapFile, RefusesOtherFormatsAndFolders) {
  const TemporaryFolder folder;
  for (const std::string name : {"map.las", "map", "map.PCD"})
    expect_error([&] { save_map(small_map(), folder.path(name)); }, {name, ".pcd, .ply, .bt or .ot"});
  for (const std::string name : {"map.pcd", "map.ply", "map.bt", "map.ot"})
    expect_error([&] { save_map(small_map(), folder.path("no/" + name)); }, {name, "does not exist"});
}

}  // namespace
}  // namespace stillmap
