#include "io/parameters_yaml.hpp"

#include <gtest/gtest.h>

#include "io/nearest_name.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

Parameters load(const std::string& yaml) {
  const TemporaryFolder folder;
  return load_parameters(folder.write("p.yaml", yaml));
}

void expect_equal(const Parameters& a, const Parameters& b) {
  EXPECT_EQ(to_yaml(a), to_yaml(b));
}

/// Moves every value off its default, inside its range.
struct OtherValue {
  void operator()(const ParameterInfo& info, double& value) const {
    value = info.min + (info.max - info.min) / 3.0;
  }
  void operator()(const ParameterInfo& info, int& value) const { value = static_cast<int>(info.max); }
  void operator()(const ParameterInfo&, bool& value) const { value = !value; }
  void operator()(const ParameterInfo& info, std::string& value) const {
    const std::string options = info.options;
    value = options.substr(options.rfind('|') + 1);
  }
  void operator()(const ParameterInfo& info, std::vector<double>& value) const {
    value.assign(2, info.min + (info.max - info.min) / 7.0);
  }
};

void expect_read_back_exactly(const Parameters& written) {
  const Parameters loaded = load(to_yaml(written));
  std::vector<std::string> differing;
  visit_parameters(loaded, [&](const ParameterInfo& info, const auto& value) {
    visit_parameters(written, [&](const ParameterInfo& other_info, const auto& other) {
      if constexpr (std::is_same_v<decltype(value), decltype(other)>)
        if (std::string(info.name) == other_info.name && !(value == other)) differing.push_back(info.name);
    });
  });
  EXPECT_TRUE(differing.empty()) << differing.front();
}

TEST(ParametersYaml, ReadsEveryValueBackExactly) {
  Parameters changed;
  visit_parameters(changed, OtherValue());
  // These two exclude each other.
  Parameters without_submaps = changed, without_rolling = changed;
  without_submaps.submap_length_m = 0;
  without_rolling.rolling_radius_m = 0;
  expect_read_back_exactly(without_submaps);
  expect_read_back_exactly(without_rolling);
}

TEST(ParametersYaml, TheFilesInConfigAreTheCode) {
  const std::string folder = CONFIG_FOLDER;
  EXPECT_EQ(read_text(folder + "/default.yaml"), to_yaml(preset("default"))) << "run `stillmap parameters`";
  EXPECT_EQ(read_text(folder + "/paper.yaml"), to_yaml(preset("paper")))
      << "run `stillmap parameters --preset paper`";
}

TEST(ParametersYaml, DocumentsMeaningUnitRangeAndOptions) {
  const std::string text = to_yaml(Parameters());
  EXPECT_NE(text.find("# edge of a voxel, the spatial element i [0.02 to 2 m]\nvoxel_size_m: 0.1\n"),
            std::string::npos);
  EXPECT_NE(text.find("[linear|sigmoid]\nconflict_strength: linear\n"), std::string::npos);
}

TEST(ParametersYaml, WhatIsNotGivenStaysAtTheBase) {
  Parameters expected;
  expected.voxel_size_m = 0.3;
  expect_equal(load("voxel_size_m: 0.3\n"), expected);
  expect_equal(load(""), Parameters());
  expected = preset("paper");
  expected.voxel_size_m = 0.3;
  expect_equal(load("voxel_size_m: 0.3\npreset: paper\n"), expected);
}

TEST(ParametersYaml, OneNumberIsAListOfOne) {
  EXPECT_EQ(load("support_rate: 2\n").support_rate_r, std::vector<double>{2.0});
}

TEST(ParametersYaml, RefusesAnUnknownNameAndSuggestsTheNearest) {
  expect_error([] { load("threads: 1\nvoxel_sise_m: 0.1\n"); },
               {"p.yaml:2", "voxel_sise_m", "unknown", "did you mean voxel_size_m"});
  expect_error([] { load("colour: red\n"); }, {"colour", "unknown", "`stillmap parameters`"});
}

TEST(ParametersYaml, RefusesAnotherType) {
  expect_error([] { load("voxel_size_m: small\n"); }, {"voxel_size_m", "'small'", "a number"});
  expect_error([] { load("voxel_size_m: [1, 2]\n"); }, {"voxel_size_m", "[1, 2]", "a number"});
  expect_error([] { load("threads: 1.5\n"); }, {"threads", "'1.5'", "a whole number"});
  expect_error([] { load("hit_is_support: 2\n"); }, {"hit_is_support", "true or false"});
  expect_error([] { load("support_rate: [1, x]\n"); }, {"support_rate", "list of numbers"});
  expect_error([] { load("conflict_strength: {a: 1}\n"); }, {"conflict_strength", "a word"});
}

TEST(ParametersYaml, RefusesWhatIsOutOfRangeAllAtOnce) {
  expect_error([] { load("voxel_size_m: 9\nthreads: 0\nconflict_strength: cubic\n"); },
               {"p.yaml", "voxel_size_m: 9", "threads: 0", "'cubic' is not one of linear|sigmoid"});
  expect_error([] { load("voxel_size_m: .nan\n"); }, {"voxel_size_m"});
}

TEST(ParametersYaml, RefusesAnUnknownPreset) {
  expect_error([] { load("preset: fast\n"); }, {"p.yaml", "preset", "'fast'", "default|paper"});
}

TEST(ParametersYaml, RefusesANameGivenTwice) {
  expect_error([] { load("threads: 1\nthreads: 2\n"); }, {"p.yaml:2", "threads", "twice"});
}

TEST(ParametersYaml, RefusesWhatIsNoMap) {
  expect_error([] { load_parameters("/no/such/file.yaml"); }, {"/no/such/file.yaml", "cannot be read"});
  expect_error([] { load("- 1\n- 2\n"); }, {"p.yaml", "name: value"});
  expect_error([] { load("a: [1\n"); }, {"p.yaml", "not YAML"});
}

TEST(ParametersYaml, SetsOneByText) {
  Parameters parameters;
  set_parameter(parameters, "angular_levels_deg", "[2.5, 2.0]");
  EXPECT_EQ(parameters.angular_levels_deg, (std::vector<double>{2.5, 2.0}));
  expect_error([&] { set_parameter(parameters, "voxel_size", "1"); }, {"did you mean voxel_size_m"});
  expect_error([&] { set_parameter(parameters, "voxel_size_m", "["); }, {"voxel_size_m", "'['"});
}

TEST(NearestName, FindsOneEditAndSeveral) {
  const std::vector<std::string> names = {"threads", "max_range_m", "min_range_m"};
  EXPECT_EQ(nearest_name("thread", names), "threads");
  EXPECT_EQ(nearest_name("maxrange", names), "max_range_m");
  EXPECT_EQ(nearest_name("zzz", names), "");
  EXPECT_EQ(nearest_name("x", {}), "");
}

}  // namespace
}  // namespace stillmap
