#include "io/semantickitti_folder.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

constexpr char kIdentity[] = "1 0 0 0 0 1 0 0 0 0 1 0\n";

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

struct SemanticKittiFolderTest : testing::Test {
  TemporaryFolder folder;

  void write_scans(int count) {
    for (int k = 0; k < count; ++k)
      folder.write("velodyne/00000" + std::to_string(k) + ".bin",
                   bytes_of<float>({1.0F + static_cast<float>(k), 2, 3, 0.5, 0, 0, 0, 0}));
  }
  SemanticKittiFolder open() { return SemanticKittiFolder(folder.path()); }
};

TEST_F(SemanticKittiFolderTest, ReadsScansInOrderWithEveryRow) {
  write_scans(2);
  folder.write("poses.txt", std::string(kIdentity) + "1 0 0 5 0 1 0 6 0 0 1 7\n");
  SemanticKittiFolder sequence = open();
  ASSERT_EQ(sequence.size(), 2u);
  const Frame frame = sequence.read(1);
  EXPECT_EQ(frame.name, "000001");
  ASSERT_EQ(frame.scan.points.size(), 2u);
  EXPECT_EQ(frame.scan.points[0], Eigen::Vector3f(2, 2, 3));
  EXPECT_EQ(frame.scan.points[1], Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(frame.T_map_sensor.translation(), Eigen::Vector3d(5, 6, 7));
}

TEST_F(SemanticKittiFolderTest, WithoutTimesItIsTenHertz) {
  write_scans(2);
  folder.write("poses.txt", std::string(kIdentity) + kIdentity);
  EXPECT_EQ(open().read(1).scan.stamp_ns, 100'000'000);
  folder.write("times.txt", "0.0\n1.036117e-01\n");
  EXPECT_EQ(open().read(1).scan.stamp_ns, 103'611'700);
}

// KITTI's axes: the camera looks along z with x right and y down, the sensor along x with y left and z up,
// so Tr takes sensor (x, y, z) to camera (-y, -z, x). A camera 10 m ahead is a sensor 10 m along its x, and a
// camera that turns about its y (down) is a sensor that turns about -z.
TEST_F(SemanticKittiFolderTest, TrTakesPosesFromTheCameraToTheSensor) {
  write_scans(2);
  folder.write("calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: 0 -1 0 0.25 0 0 -1 0 1 0 0 -0.5\n");
  folder.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 10\n0 0 1 0 0 1 0 0 -1 0 0 0\n");
  SemanticKittiFolder sequence = open();
  EXPECT_TRUE(sequence.read(0).T_map_sensor.linear().isIdentity(1e-12));
  EXPECT_TRUE(sequence.read(0).T_map_sensor.translation().isApprox(Eigen::Vector3d(10, 0, 0), 1e-12));

  // By hand: sensor (0, 0, 0) is camera (0.25, 0, -0.5); turned (-0.5, 0, -0.25); back in the sensor's axes
  // Tr^-1 (p - t) with p - t = (-0.75, 0, 0.25) is (0.25, 0.75, 0).
  const Eigen::Isometry3d turned = sequence.read(1).T_map_sensor;
  EXPECT_TRUE(turned.translation().isApprox(Eigen::Vector3d(0.25, 0.75, 0), 1e-12));
  EXPECT_TRUE((turned.linear() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY(), 1e-12));
}

TEST_F(SemanticKittiFolderTest, RoundedPosesBecomeExactRotations) {
  write_scans(1);
  folder.write("poses.txt", "0.99990 -0.0141 0 0 0.0141 0.99990 0 0 0 0 1 0\n");
  const Eigen::Matrix3d rotation = open().read(0).T_map_sensor.linear();
  EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-12));
}

TEST_F(SemanticKittiFolderTest, APartOfASequenceTakesPosesByNumber) {
  folder.write("velodyne/000001.bin", bytes_of<float>({1, 2, 3, 4}));
  folder.write("poses.txt", std::string(kIdentity) + "1 0 0 5 0 1 0 6 0 0 1 7\n" + kIdentity);
  EXPECT_EQ(open().read(0).T_map_sensor.translation(), Eigen::Vector3d(5, 6, 7));
  folder.write("velodyne/000007.bin", bytes_of<float>({1, 2, 3, 4}));
  expect_error([&] { open(); }, {"000007.bin", "3 poses"});
}

TEST_F(SemanticKittiFolderTest, RefusesMissingParts) {
  expect_error([&] { open(); }, {folder.path(), "velodyne/"});
  std::filesystem::create_directories(folder.path("velodyne"));
  expect_error([&] { open(); }, {"velodyne", "no .bin file"});
  write_scans(1);
  expect_error([&] { open(); }, {"poses.txt", "cannot be read"});
}

TEST_F(SemanticKittiFolderTest, RefusesFewerPosesThanScans) {
  write_scans(3);
  folder.write("poses.txt", std::string(kIdentity) + kIdentity);
  expect_error([&] { open(); }, {"poses.txt", "2 poses", "3 scans"});
}

TEST_F(SemanticKittiFolderTest, RefusesABadPoseByItsLine) {
  write_scans(2);
  for (const std::string bad :
       {"1 0 0 0 0 1 0 0 0 0 1\n", "1 0 0 0 0 1 0 0 0 0 1 x\n", "1 0 0 0 0 1 0 0 0 0 1 0 9\n",
        "2 0 0 0 0 1 0 0 0 0 1 0\n", "-1 0 0 0 0 1 0 0 0 0 1 0\n", "nan 0 0 0 0 1 0 0 0 0 1 0\n",
        "1 0 0 inf 0 1 0 0 0 0 1 0\n"}) {
    folder.write("poses.txt", kIdentity + bad);
    expect_error([&] { open(); }, {"poses.txt:2"});
  }
}

TEST_F(SemanticKittiFolderTest, RefusesABadTr) {
  write_scans(1);
  folder.write("poses.txt", kIdentity);
  folder.write("calib.txt", "Tr: 1 0 0\n");
  expect_error([&] { open(); }, {"calib.txt", "Tr", "12 numbers"});
}

TEST_F(SemanticKittiFolderTest, RefusesTimesThatDoNotFit) {
  write_scans(2);
  folder.write("poses.txt", std::string(kIdentity) + kIdentity);
  folder.write("times.txt", "0.0\n");
  expect_error([&] { open(); }, {"times.txt", "1 times", "2 poses"});
  folder.write("times.txt", "0.0\nsoon\n");
  expect_error([&] { open(); }, {"times.txt"});
}

TEST_F(SemanticKittiFolderTest, RefusesACutOffScan) {
  folder.write("velodyne/000000.bin", "seventeen bytes!!");
  folder.write("poses.txt", kIdentity);
  expect_error([&] { open().read(0); }, {"000000.bin", "17 bytes"});
}

TEST_F(SemanticKittiFolderTest, AnEmptyScanHasNoRows) {
  folder.write("velodyne/000000.bin", "");
  folder.write("poses.txt", kIdentity);
  EXPECT_TRUE(open().read(0).scan.points.empty());
}

TEST(ReadLabels, OneForEachPoint) {
  const TemporaryFolder folder;
  const std::vector<std::uint32_t> labels = {9, 252 | (7U << 16), 0};
  const std::string file = folder.write("000000.label", bytes_of(labels));
  EXPECT_EQ(read_labels(file, 3), labels);
  expect_error([&] { read_labels(file, 4); }, {"000000.label", "12 bytes", "4 points"});
  expect_error([&] { read_labels(folder.path("no.label"), 1); }, {"no.label", "cannot be read"});
}

}  // namespace
}  // namespace stillmap
