// Pieces of one scan's surface: boxes apart, and connectivity against brute force.
#include "core/clusters.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "core/for_rows.hpp"
#include "core/made_scans.hpp"

namespace stillmap {
namespace {

const Rings kSensor{64, 1024, -22.5F, 22.5F};
const SensorGeometry kGeometry{kSensor.spacing_deg() * kRad, kSensor.step_deg() * kRad};

/// Plates 10 m ahead, 1.6 m high, each between two azimuths in degrees.
Scan plates(const std::vector<std::pair<float, float>>& azimuths_deg) {
  return kSensor.scan([&](float azimuth, float elevation) {
    if (std::abs(elevation) > 4.5F * kRad) return 0.0F;
    for (const auto& [from, to] : azimuths_deg)
      if (azimuth > from * kRad && azimuth < to * kRad) return 10 / (std::cos(azimuth) * std::cos(elevation));
    return 0.0F;
  });
}

std::vector<std::uint32_t> all_usable(const ProjectedScan& scan) {
  std::vector<std::uint32_t> rows;
  find_rows(scan.size(), rows, [&](std::size_t row) { return scan.range_m[row] > 0; });
  return rows;
}

TEST(Clusters, OnePlateIsOne) {
  const Scan scan = plates({{-6, 6}});
  const ProjectedScan p = projected(scan);
  Clusters clusters;
  clusters.find(p, kGeometry, all_usable(p));
  EXPECT_EQ(clusters.count(), 1U);
  for (std::size_t row = 0; row < p.size(); ++row)
    EXPECT_EQ(clusters.of_row()[row], p.range_m[row] > 0 ? 0 : Clusters::kNone);
}

TEST(Clusters, TwoPlatesApartAreTwo) {
  const Scan scan = plates({{-16, -6}, {6, 16}});
  const ProjectedScan p = projected(scan);
  Clusters clusters;
  clusters.find(p, kGeometry, all_usable(p));
  ASSERT_EQ(clusters.count(), 2U);
  std::map<bool, std::set<std::int32_t>> of_side;
  for (std::size_t row = 0; row < p.size(); ++row)
    if (p.range_m[row] > 0) of_side[p.azimuth_rad[row] > 0].insert(clusters.of_row()[row]);
  EXPECT_EQ(of_side[false].size(), 1U);
  EXPECT_EQ(of_side[true].size(), 1U);
  EXPECT_NE(of_side[false], of_side[true]);
}

// Stripes of columns are joined by different threads.
TEST(Clusters, AWallAllAroundIsOne) {
  const Scan scan = kSensor.scan([](float, float elevation) { return 10 / std::cos(elevation); });
  const ProjectedScan p = projected(scan);
  Clusters clusters;
  clusters.find(p, kGeometry, all_usable(p));
  EXPECT_EQ(clusters.count(), 1U);
}

TEST(Clusters, ADepthEdgeParts) {
  const Scan scan = kSensor.scan([](float azimuth, float) { return azimuth > 0 ? 10.0F : 14.0F; });
  const ProjectedScan p = projected(scan);
  Clusters clusters;
  clusters.find(p, kGeometry, all_usable(p));
  EXPECT_EQ(clusters.count(), 2U);
}

TEST(Clusters, AReturnHiddenInItsPixelGoesWithWhatItTouches) {
  Scan scan = kSensor.scan([](float azimuth, float) { return azimuth > 0 ? 10.0F : 14.0F; });
  const std::size_t first_hidden =
      scan.points.size();  // of the far wall, a little behind the near one's edge
  for (int ring = 8; ring < 56; ++ring) {
    const float elevation = (-22.5F + static_cast<float>(ring) * kSensor.spacing_deg()) * kRad;
    scan.points.emplace_back(14 * direction(0.2F * kSensor.step_deg() * kRad, elevation));
  }
  const ProjectedScan p = projected(scan);
  Clusters clusters;
  clusters.find(p, kGeometry, all_usable(p));
  ASSERT_EQ(clusters.count(), 2U);
  const std::int32_t far_wall = clusters.of_row()[0];
  for (std::size_t row = first_hidden; row < p.size(); ++row) EXPECT_EQ(clusters.of_row()[row], far_wall);
}

TEST(Clusters, RowsThatTakeNoPartHaveNone) {
  const Scan scan = plates({{-16, -6}, {6, 16}});
  const ProjectedScan p = projected(scan);
  const auto takes_part = [&](std::size_t row) { return p.range_m[row] > 0 && p.azimuth_rad[row] > 0; };
  std::vector<std::uint32_t> rows;
  find_rows(p.size(), rows, takes_part);
  Clusters clusters;
  clusters.find(p, kGeometry, rows);
  EXPECT_EQ(clusters.count(), 1U);
  for (std::size_t row = 0; row < p.size(); ++row)
    EXPECT_EQ(clusters.of_row()[row] != Clusters::kNone, takes_part(row));
}

/// The rows' clusters by flood fill over all pairs of rows that are their pixels' nearest.
std::vector<int> by_brute_force(const Scan& scan, const ProjectedScan& p) {
  const SphericalGrid grid(2 * kGeometry.azimuth_step_rad, 0.75F * kGeometry.ring_spacing_rad,
                           p.elevation_min_rad, p.elevation_max_rad);
  std::map<int, int> nearest;  // of each pixel
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!(p.range_m[i] > 0)) continue;
    const int row = static_cast<int>(i);
    const auto [it, created] = nearest.try_emplace(grid.pixel(p.azimuth_rad[i], p.elevation_rad[i]), row);
    if (p.range_m[i] < p.range_m[it->second]) it->second = row;
  }
  const auto touch = [&](int pixel_a, int a, int pixel_b, int b) {
    const int apart = std::abs(pixel_a / grid.rows - pixel_b / grid.rows);
    const int columns = std::min(apart, grid.columns - apart);
    const int rows = std::abs(pixel_a % grid.rows - pixel_b % grid.rows);
    const float spacing = std::max(kGeometry.ring_spacing_rad, 2 * kGeometry.azimuth_step_rad);
    const float reach_m = 0.25F + 1.2F * spacing * std::min(p.range_m[a], p.range_m[b]);
    return columns <= 2 && rows <= (columns == 2 ? 1 : 2) &&
           (scan.points[a] - scan.points[b]).norm() <= reach_m;
  };
  std::vector<int> cluster(p.size(), -1);
  int count = 0;
  for (const auto& [start_pixel, start] : nearest) {
    if (cluster[start] >= 0) continue;
    cluster[start] = count;
    std::vector<std::pair<int, int>> open = {{start_pixel, start}};
    while (!open.empty()) {
      const auto [pixel, row] = open.back();
      open.pop_back();
      for (const auto& [other_pixel, other] : nearest)
        if (cluster[other] < 0 && touch(pixel, row, other_pixel, other)) {
          cluster[other] = count;
          open.emplace_back(other_pixel, other);
        }
    }
    ++count;
  }
  return cluster;
}

// Returns of one pixel are connected by their ranges alone where these are close: never what is too far
// apart.
TEST(Clusters, ReturnsOfOnePixelAreTogetherAsFarAsTheyReach) {
  const float kRange_m = 10, kReach_m = 0.25F + 1.2F * kSensor.spacing_deg() * kRad * kRange_m;
  for (int step = 1; step < 100; ++step) {
    const float deeper_m = 0.01F * static_cast<float>(step);
    if (std::abs(deeper_m - kReach_m) < 0.001F) continue;
    Scan scan = plates({{-6, 6}});
    for (const float range_m : {kRange_m, kRange_m + deeper_m})
      scan.points.emplace_back(range_m * direction(90 * kRad, 0));
    const ProjectedScan p = projected(scan);
    Clusters clusters;
    clusters.find(p, kGeometry, all_usable(p));
    const auto& of_row = clusters.of_row();
    EXPECT_EQ(of_row.back() == of_row[of_row.size() - 2], deeper_m < kReach_m) << deeper_m;
  }
}

TEST(Clusters, APixelBelowIsOneFromWhichItIsFoundAbove) {
  const ProjectedScan p = projected(plates({{-6, 6}}));
  Clusters clusters;
  clusters.find(p, kGeometry, all_usable(p));
  const auto pixel_of = [&](std::uint32_t row) {
    return clusters.pixel(p.azimuth_rad[row], p.elevation_rad[row]);
  };
  std::uint32_t row = all_usable(p)[100];
  while (!clusters.is_in_front(row, pixel_of(row))) ++row;
  const int here = pixel_of(row);
  std::set<int> below;
  clusters.for_each_below(here, [&](int pixel) { below.insert(pixel); });
  const auto is_it = [&](std::int32_t other) { return other == static_cast<std::int32_t>(row); };
  for (int pixel = 0; pixel < static_cast<int>(clusters.pixels()); ++pixel)
    EXPECT_EQ(clusters.any_above(pixel, is_it), below.count(pixel) != 0) << pixel;
}

TEST(Clusters, ConnectAsBruteForceDoes) {
  std::mt19937 random(10);
  std::uniform_real_distribution<float> share(0, 1);
  for (int trial = 0; trial < 6; ++trial) {
    float range_m = 8;
    const Scan scan = kSensor.scan([&](float azimuth, float elevation) {
      if (share(random) < 0.1F) range_m = 5 + 10 * share(random);
      // Over the seam, or over the edge between two stripes.
      const bool here = trial % 2 == 0 ? std::abs(azimuth) > 170 * kRad : std::abs(azimuth) < 10 * kRad;
      return here && std::abs(elevation) < 8 * kRad && share(random) < 0.6F ? range_m : 0.0F;
    });
    const ProjectedScan p = projected(scan);
    Clusters clusters;
    clusters.find(p, kGeometry, all_usable(p));
    const std::vector<int> expected = by_brute_force(scan, p);
    std::map<int, int> found_of, expected_of;
    for (std::size_t row = 0; row < p.size(); ++row) {
      if (expected[row] < 0) continue;  // not its pixel's nearest
      const int found = clusters.of_row()[row];
      EXPECT_EQ(found_of.try_emplace(expected[row], found).first->second, found);
      EXPECT_EQ(expected_of.try_emplace(found, expected[row]).first->second, expected[row]);
    }
    EXPECT_GT(found_of.size(), 10U);
  }
}

}  // namespace
}  // namespace stillmap
