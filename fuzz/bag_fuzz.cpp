// Bags: opened, their poses and clouds read, as `label` and `doctor` do.

#include "expect.hpp"
#include "input.hpp"
#include "messages/bag_sequence.hpp"
#include "scratch_folder.hpp"

namespace stillmap::fuzz {
namespace {

void read_all(const std::string& file) {
  BagSequence sequence(file, BagInput{});
  for (std::size_t k = 0; k < sequence.size(); ++k)
    expect(sequence.read(k).T_map_sensor.matrix().allFinite(), "a pose that was accepted is finite");
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stillmap::fuzz;
  Input in(data, size);
  const std::string file = ScratchFolder::instance().write("given.bag", in.take_all());
  expect_named_refusal(file, [&] { read_all(file); });
  return 0;
}
