// doc/reference.md, and the tables of presets in README.md and doc/odometry.md, are what the code says.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

/// The definitions of services have no comments with the gencpp of Ubuntu 20.04.
std::string without_comments(const std::string& text) {
  return std::regex_replace(text, std::regex(" *#[^\n]*"), "");
}

TEST(Reference, IsWhatTheCommandPrints) {
  TemporaryFolder folder;
  const std::string printed = folder.path("reference.md");
  ASSERT_EQ(std::system((STILLMAP_COMMAND " reference > " + printed).c_str()), 0);
  const std::string text = read_text(printed), kept = read_text(STILLMAP_FOLDER "/doc/reference.md");
  if (text.find("bool overwrite  ") == std::string::npos)
    EXPECT_EQ(without_comments(text), without_comments(kept));
  else
    EXPECT_EQ(text, kept) << "make it anew: stillmap reference > doc/reference.md";
}

// doc/odometry.md has one column more.
TEST(Reference, PresetsAreThoseOfTheFiles) {
  TemporaryFolder folder;
  const std::string printed = folder.path("presets.md");
  ASSERT_EQ(std::system((STILLMAP_COMMAND " reference --presets > " + printed).c_str()), 0);
  const std::string readme = read_text(STILLMAP_FOLDER "/README.md");
  const std::string odometry = read_text(STILLMAP_FOLDER "/doc/odometry.md");
  std::ifstream table(printed);
  std::size_t rows = 0;
  for (std::string row; std::getline(table, row); ++rows) {
    EXPECT_NE(readme.find(row + "\n"), std::string::npos) << "README.md: " << row;
    EXPECT_NE(odometry.find(row), std::string::npos) << "doc/odometry.md: " << row;
  }
  EXPECT_EQ(rows, 14u) << "twelve presets below two lines of heading";
}

}  // namespace
}  // namespace stillmap
