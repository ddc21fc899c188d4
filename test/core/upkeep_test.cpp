// Labels first, the map's upkeep later: the same labels and the same map, whenever it is done.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

std::vector<Frame> recorded() {
  SimulationOptions options;
  options.scene = "plaza";
  options.sensor = "vlp16";
  options.scans = 10;
  const Simulator simulator(options);
  std::vector<Frame> frames;
  for (std::size_t k = 0; k < options.scans; ++k) frames.push_back(simulator.frame(k).frame);
  return frames;
}

void expect_same(const ScanLabels& a, const ScanLabels& b) {
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.p_static, b.p_static);
  EXPECT_EQ(a.reason, b.reason);
}

void expect_same_map(const MapContents& a, const MapContents& b) {
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    ASSERT_EQ(a.blocks[i].key, b.blocks[i].key);
    ASSERT_EQ(a.blocks[i].occupied, b.blocks[i].occupied);
    const std::vector<Voxel>&voxels = a.blocks[i].voxels, &others = b.blocks[i].voxels;
    ASSERT_EQ(std::memcmp(voxels.data(), others.data(), voxels.size() * sizeof(Voxel)), 0);
  }
}

/// Labels in two steps with something done in between, against process().
void expect_as_process(const Parameters& parameters, const std::function<void(Mapper&)>& between) {
  Mapper whole(parameters), steps(parameters);
  for (const Frame& frame : recorded()) {
    const ScanLabels labels = whole.process(frame.scan, frame.T_map_sensor);
    expect_same(steps.label(frame.scan, frame.T_map_sensor), labels);
    between(steps);
  }
  expect_same_map(steps.export_map(), whole.export_map());
}

TEST(Upkeep, AfterTheLabelsOrBeforeTheNext) {
  for (const char* name : {"default", "paper"}) {
    expect_as_process(preset(name), [](Mapper& mapper) { mapper.upkeep(); });
    expect_as_process(preset(name), [](Mapper&) {});
  }
}

TEST(Upkeep, OfOnlyTheNearestVoxels) {
  Parameters p;
  p.evidence_goes_to = "nearest_voxel";
  expect_as_process(p, [](Mapper&) {});
}

TEST(Upkeep, IsDoneBeforeSomebodyLooksAtTheMap) {
  const std::vector<Frame> frames = recorded();
  const Frame& first = frames.front();
  Mapper whole{Parameters{}}, steps{Parameters{}};
  ScanLabels of_first;
  for (const Frame& frame : frames) {
    const ScanLabels labels = whole.process(frame.scan, frame.T_map_sensor);
    if (&frame == &first) of_first = labels;
    expect_same(steps.label(frame.scan, frame.T_map_sensor), labels);
    expect_same(steps.relabel(first.scan, first.T_map_sensor, of_first),
                whole.relabel(first.scan, first.T_map_sensor, of_first));
    steps.label(frame.scan, frame.T_map_sensor);
    whole.process(frame.scan, frame.T_map_sensor);
    const Eigen::Vector3d place = frame.T_map_sensor * frame.scan.points[100].cast<double>();
    EXPECT_EQ(in_words(steps.explain(place)), in_words(whole.explain(place)));
  }
}

TEST(Upkeep, IsAStageOfItsOwn) {
  struct Listener : StageListener {
    std::vector<Stage> heard;
    void stage_ended(Stage stage) override { heard.push_back(stage); }
  } listener;
  const Frame frame = recorded().front();
  Mapper mapper{Parameters{}};
  mapper.set_listener(&listener);
  mapper.label(frame.scan, frame.T_map_sensor);
  ASSERT_EQ(listener.heard.size(), std::size_t{kStageCount - 1});
  EXPECT_EQ(listener.heard.back(), Stage::kObjects);
  mapper.upkeep();
  mapper.upkeep();  // nothing is due any more
  ASSERT_EQ(listener.heard.size(), std::size_t{kStageCount});
  EXPECT_EQ(listener.heard.back(), Stage::kUpkeep);
}

}  // namespace
}  // namespace stillmap
