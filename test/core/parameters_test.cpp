// The list of parameters: the defaults hold, and each refusal names its parameter.
#include "stillmap/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "stillmap/mapper.hpp"
#include "stillmap/voxel.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

/// Puts one bad value into the parameter at a place of the list; false where its kind has none.
struct Spoil {
  std::size_t place;
  double (*bad)(const ParameterInfo&);
  std::string name = {};
  std::size_t here = 0;

  template <class Value>
  void operator()(const ParameterInfo& info, Value& value) {
    if (here++ != place) return;
    if constexpr (std::is_same_v<Value, double>) value = bad(info), name = info.name;
    if constexpr (std::is_same_v<Value, int>)
      if (std::isfinite(bad(info))) value = static_cast<int>(bad(info)), name = info.name;
    if constexpr (std::is_same_v<Value, std::vector<double>>) value.back() = bad(info), name = info.name;
    if constexpr (std::is_same_v<Value, std::string>)
      if (*info.options != '\0') value = "nonsense", name = info.name;
  }
};

void expect_each_refused(double (*bad)(const ParameterInfo&)) {
  std::size_t count = 0;
  Parameters all;
  visit_parameters(all, [&](const ParameterInfo&, auto&) { ++count; });
  for (std::size_t place = 0; place < count; ++place) {
    Parameters p;
    Spoil spoil{place, bad};
    visit_parameters(p, spoil);
    if (spoil.name.empty()) continue;
    const std::vector<std::string> found = problems(p);
    ASSERT_FALSE(found.empty()) << spoil.name;
    EXPECT_EQ(found.front().rfind(spoil.name + ":", 0), 0U) << found.front();
    expect_error<std::invalid_argument>([&] { Mapper{p}; }, {spoil.name});
  }
}

TEST(Parameters, PresetsAreValid) {
  EXPECT_TRUE(problems(preset("default")).empty());
  EXPECT_TRUE(problems(preset("paper")).empty());
}

TEST(Parameters, PaperIsTheLiteralReading) {
  const Parameters p = preset("paper");
  EXPECT_EQ(p.angular_levels_deg, (std::vector<double>{2.5, 2.0, 1.5}));
  EXPECT_EQ(p.evidence_goes_to, "every_voxel");
  EXPECT_EQ(p.voxel_size_m, 0.05);  // table 1
  EXPECT_EQ(p.gate_voxel_support, 3);
  EXPECT_EQ(p.gate_neighbourhood_support, 60);
  EXPECT_EQ(p.gate_grid_support, 12);
  EXPECT_EQ(p.gate_height_above_ground_m, 0.6);
  EXPECT_EQ(p.history_recent + p.history_spread, 0);
}

TEST(Parameters, TheRollingMapIsNotSmallerThanAScan) {
  Parameters p;
  p.rolling_radius_m = 50;
  EXPECT_EQ(problems(p),
            std::vector<std::string>{"rolling_radius_m: below max_range_m; give 0 (off) or at least that"});
  p.rolling_radius_m = p.max_range_m;
  p.rolling_directory = "any text";
  EXPECT_TRUE(problems(p).empty());
}

TEST(Parameters, UnknownPresetIsRefused) {
  expect_error<std::invalid_argument>([] { preset("papr"); }, {"papr", "default", "paper"});
}

TEST(Parameters, EachHasANameOfItsOwnAndAMeaning) {
  std::set<std::string> names;
  Parameters p;
  visit_parameters(p, [&](const ParameterInfo& info, auto&) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_STRNE(info.help, "") << info.name;
  });
  EXPECT_GT(names.size(), 30U);
}

TEST(Parameters, TooSmallIsRefused) {
  expect_each_refused([](const ParameterInfo& info) { return info.min - 1; });
}

TEST(Parameters, TooLargeIsRefused) {
  expect_each_refused([](const ParameterInfo& info) { return info.max + 1; });
}

TEST(Parameters, NotANumberIsRefused) {
  expect_each_refused([](const ParameterInfo&) { return std::numeric_limits<double>::quiet_NaN(); });
}

TEST(Parameters, AnEmptyListIsRefused) {
  Parameters p;
  p.angular_levels_deg.clear();
  ASSERT_FALSE(problems(p).empty());
  EXPECT_NE(problems(p).front().find("angular_levels_deg: the list is empty"), std::string::npos);
}

TEST(Parameters, AListThatFitsNoLevelIsRefused) {
  Parameters p;
  p.angular_levels_deg = {2.5, 2.0, 1.5};
  p.conflict_rate_r = {1.2, 1.3};
  ASSERT_EQ(problems(p).size(), 1U);
  EXPECT_NE(problems(p).front().find("conflict_rate: 2 values for 3"), std::string::npos);
}

TEST(Parameters, RangesThatExcludeEverythingAreRefused) {
  Parameters p;
  p.min_range_m = 10;
  p.max_range_m = 5;
  ASSERT_EQ(problems(p).size(), 1U);
  EXPECT_NE(problems(p).front().find("min_range_m"), std::string::npos);
}

TEST(Parameters, AMapperNamesEveryBadOneAtOnce) {
  Parameters p;
  p.voxel_size_m = -1;
  p.increment_clip = 1000;
  expect_error<std::invalid_argument>([&] { Mapper{p}; }, {"voxel_size_m", "increment_clip"});
}

TEST(Parameters, AVoxelHoldsEveryLogOddsThatIsAllowed) {
  Parameters p;
  visit_parameters(p, [](const ParameterInfo& info, auto&) {
    if (std::string(info.name).rfind("log_odds_", 0) != 0) return;
    for (const double bound : {info.min, info.max}) {
      Voxel voxel;
      voxel.set_log_odds(static_cast<float>(bound));
      EXPECT_NEAR(voxel.log_odds(), bound, 1e-3) << info.name;
    }
  });
}

}  // namespace
}  // namespace stillmap
