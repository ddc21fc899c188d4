// Parameter files, single values as the parameter server and --set give them, and the texts of poses.

#include <stdexcept>

#include "expect.hpp"
#include "input.hpp"
#include "io/parameters_yaml.hpp"
#include "messages/pairing_options.hpp"
#include "scratch_folder.hpp"

namespace stillmap::fuzz {
namespace {

/// What of a text an error message can hold.
std::string up_to_zero(const std::string& text) {
  return text.c_str();
}

void set_one(Input& in) {
  const std::string name = up_to_zero(in.take_part("="));
  Parameters parameters;
  expect_named_refusal(name, [&] {
    set_parameter(parameters, name, up_to_zero(in.take_all()));
    check_parameters(parameters, name);
  });
}

void load_file(Input& in) {
  const std::string file = ScratchFolder::instance().write("given.yaml", up_to_zero(in.take_all()));
  expect_named_refusal(file, [&] {
    const Parameters parameters = load_parameters(file);
    const std::string again = ScratchFolder::instance().write("again.yaml", to_yaml(parameters));
    expect(to_yaml(load_parameters(again)) == to_yaml(parameters), "what was accepted reads back");
  });
}

void parse_pose(Input& in) {
  expect_named_refusal("sensor_on_body", [&] {
    expect(parse_sensor_on_body(up_to_zero(in.take_all())).matrix().allFinite(),
           "an accepted pose is finite");
  });
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stillmap::fuzz;
  Input in(data, size);
  switch (in.choose(3)) {
    case 0:
      set_one(in);
      break;
    case 1:
      load_file(in);
      break;
    default:
      parse_pose(in);
  }
  return 0;
}
