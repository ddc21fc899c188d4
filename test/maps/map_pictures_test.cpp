// The pictures show what is there: high is yellow, low is blue, what appeared is green.
#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>

#include "maps/change_list.hpp"
#include "maps/export_map.hpp"
#include "maps/two_sessions.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap::simulation {
namespace {

struct Png {
  png_image image{};
  std::vector<std::uint8_t> pixels;

  explicit Png(const std::string& path) {
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    pixels.resize(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0) << image.message;
  }
  /// Of a place in metres, where `low` is the lower left corner and pixels are 0.1 m.
  const std::uint8_t* at(const Eigen::Vector2d& low, double x, double y) const {
    const int column = static_cast<int>((x - low.x()) / 0.1);
    const int row = static_cast<int>(image.height) - 1 - static_cast<int>((y - low.y()) / 0.1);
    return &pixels[3 * (static_cast<std::size_t>(row) * image.width + column)];
  }
};

Eigen::Vector2d corner_in(const std::string& words) {
  Eigen::Vector2d corner;
  const std::string before = "corner at (";
  const char* numbers = words.c_str() + words.find(before) + before.size();
  EXPECT_EQ(std::sscanf(numbers, "%lf, %lf", &corner.x(), &corner.y()), 2) << words;
  return corner;
}

TEST(MapPictures, HeightsAreColours) {
  const TemporaryFolder folder;
  const std::string path = folder.path("heights.png");
  const Eigen::Vector2d low = corner_in(export_map(session({}), decision_of(Parameters()), path));
  const Png png(path);
  EXPECT_NEAR(png.image.width, 303, 8);
  int yellow = 0, blue = 0;  // of the wall and of the ground before it
  for (double y = -2; y < 2; y += 0.1) {
    const std::uint8_t *ground = png.at(low, 2, y), *wall = png.at(low, 14.9, y);
    blue += ground[2] > ground[1];
    yellow += wall[0] > wall[2];
  }
  EXPECT_GT(blue, 5);
  EXPECT_GT(yellow, 20);
}

TEST(MapPictures, ChangesAreGreenAndRed) {
  const TemporaryFolder folder;
  const MapDiff found = diff(session({{4, -4}}), session({{7, 2}}), decision_of(Parameters()), DiffOptions());
  const std::string path = folder.path("diff.png");
  const Eigen::Vector2d low = corner_in(save_diff_picture(found, path));
  const Png png(path);
  std::size_t green = 0, red = 0;
  for (double x = -0.6; x < 0.6; x += 0.1)
    for (double y = -0.6; y < 0.6; y += 0.1) {
      const std::uint8_t *appeared = png.at(low, 7 + x, 2 + y), *gone = png.at(low, 4 + x, -4 + y);
      green += appeared[1] > 2 * appeared[0];
      red += gone[0] > 2 * gone[1];
    }
  EXPECT_GT(green, 10U);
  EXPECT_GT(red, 10U);
  EXPECT_NE(csv_of(found).find("\nappeared,"), std::string::npos);
  EXPECT_NE(csv_of(found).find("\ngone,"), std::string::npos);
}

TEST(MapPictures, AnEmptyMapIsRefused) {
  const TemporaryFolder folder;
  MapContents empty;
  empty.voxel_size_m = 0.1;
  expect_error<std::invalid_argument>(
      [&] { export_map(empty, decision_of(Parameters()), folder.path("a.png")); }, {"no static voxel"});
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.png")));
}

}  // namespace
}  // namespace stillmap::simulation
