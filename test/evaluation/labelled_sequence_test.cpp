#include "evaluation/labelled_sequence.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Five scans of four points each; point i of scan k has the label 40 + i.
struct LabelledSequenceTest : testing::Test {
  TemporaryFolder folder;

  LabelledSequenceTest() {
    std::string poses;
    for (int k = 0; k < 5; ++k) {
      const std::string name = "00000" + std::to_string(k);
      folder.write("velodyne/" + name + ".bin",
                   bytes_of(std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0}));
      folder.write("labels/" + name + ".label", bytes_of(std::vector<std::uint32_t>{40, 41, 42, 43}));
      poses += "1 0 0 0 0 1 0 0 0 0 1 0\n";
    }
    folder.write("poses.txt", poses);
  }
  std::unique_ptr<LabelledSequence> open() const { return std::make_unique<LabelledFolder>(folder.path()); }
};

TEST_F(LabelledSequenceTest, LabelsNowAreTheLabelsUnlessGiven) {
  EXPECT_EQ(open()->read(1).labels_now, (std::vector<std::uint32_t>{40, 41, 42, 43}));
  for (int k = 0; k < 5; ++k)
    folder.write("labels_now/00000" + std::to_string(k) + ".label",
                 bytes_of(std::vector<std::uint32_t>{9, 9, 9, 9}));
  EXPECT_EQ(open()->read(1).labels_now, (std::vector<std::uint32_t>{9, 9, 9, 9}));
  EXPECT_EQ(open()->read(1).labels, (std::vector<std::uint32_t>{40, 41, 42, 43}));
}

TEST_F(LabelledSequenceTest, APart) {
  PartOptions options;
  options.first = 1;
  options.stride = 2;
  SequencePart part(open(), options);
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(part.read(1).frame.name, "000003");
  options.count = 1;
  EXPECT_EQ(SequencePart(open(), options).size(), 1u);
  options.first = 7;
  expect_error([&] { SequencePart(open(), options); }, {"number 7", "only 5 scans"});
}

TEST_F(LabelledSequenceTest, AChoiceOfReturnsKeepsOrderAndLabels) {
  PartOptions options;
  options.max_points = 2;
  SequencePart part(open(), options);
  const LabelledFrame scan = part.read(0);
  ASSERT_EQ(scan.labels.size(), 2u);
  ASSERT_EQ(scan.frame.scan.points.size(), 2u);
  EXPECT_LT(scan.labels[0], scan.labels[1]);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_FLOAT_EQ(scan.frame.scan.points[i].x(), static_cast<float>(scan.labels[i] - 39));
  EXPECT_EQ(part.read(0).labels, scan.labels);
  options.max_points = 100;
  EXPECT_EQ(SequencePart(open(), options).read(0).labels, (std::vector<std::uint32_t>{40, 41, 43}));
}

TEST_F(LabelledSequenceTest, TheSeedChangesTheChoice) {
  const auto chosen = [](std::uint64_t seed) {
    LabelledFrame scan;
    for (std::uint32_t i = 0; i < 1000; ++i) scan.labels.push_back(i);
    scan.labels_now = scan.labels;
    scan.frame.scan.points.assign(1000, {1, 0, 0});
    thin_out(scan, 100, seed, 0);
    return scan.labels;
  };
  EXPECT_EQ(chosen(7), chosen(7));
  EXPECT_NE(chosen(7), chosen(8));
}

TEST_F(LabelledSequenceTest, BrokenInputIsRefusedByName) {
  expect_error([&] { LabelledFolder("/no/such/folder"); }, {"/no/such/folder: no such folder"});
  folder.write("labels/000002.label", "12345678");
  expect_error([&] { open()->read(2); }, {"000002.label", "8 bytes, but 4 points need 16"});
  folder.write("velodyne/000003.bin", "cut off");
  expect_error([&] { open()->read(3); }, {"000003.bin", "7 bytes"});
  std::filesystem::remove(folder.path("poses.txt"));
  expect_error([&] { open(); }, {"poses.txt"});
  std::filesystem::remove_all(folder.path("labels"));
  folder.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  expect_error([&] { open(); }, {"1 poses for 5 scans"});
}

TEST_F(LabelledSequenceTest, WithoutLabelsThereIsNoTruth) {
  std::filesystem::remove_all(folder.path("labels"));
  expect_error([&] { open(); }, {"no folder labels/"});
}

}  // namespace
}  // namespace stillmap
