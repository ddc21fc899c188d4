// A SemanticKITTI folder: the input holds poses.txt, calib.txt, times.txt, a .label and a .bin, separated by
// "----".

#include "expect.hpp"
#include "input.hpp"
#include "io/semantickitti_folder.hpp"
#include "scratch_folder.hpp"

namespace stillmap::fuzz {
namespace {

constexpr char kSeparator[] = "----";

void read_sequence(const std::string& folder, const std::string& labels) {
  SemanticKittiFolder sequence(folder);
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const Frame frame = sequence.read(k);
    expect(frame.T_map_sensor.matrix().allFinite(), "a pose that was accepted is finite");
    expect(read_labels(labels, frame.scan.points.size()).size() == frame.scan.points.size(),
           "a label for each point");
  }
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stillmap::fuzz;
  Input in(data, size);
  const ScratchFolder& scratch = ScratchFolder::instance();
  for (const char* name : {"poses.txt", "calib.txt", "times.txt"})
    scratch.write(std::string("sequence/") + name, in.take_part(kSeparator));
  const std::string labels = scratch.write("sequence/0.label", in.take_part(kSeparator));
  scratch.write("sequence/velodyne/000000.bin", in.take_all());
  expect_named_refusal(scratch.path("sequence"), [&] { read_sequence(scratch.path("sequence"), labels); });
  return 0;
}
