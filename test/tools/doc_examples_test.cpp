// The examples of doc/maps.md that need no running node, one after the other as a reader would type them.
#include <gtest/gtest.h>

#include <fstream>

#include "support/run_command.hpp"

namespace stillmap {
namespace {

/// Lines of code blocks that begin with `stillmap `, without what a # begins.
std::vector<std::string> examples_in(const std::string& page) {
  std::vector<std::string> examples;
  std::ifstream stream(page);
  bool in_code = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("```", 0) == 0) in_code = !in_code;
    if (in_code && line.rfind("stillmap ", 0) == 0) examples.push_back(line.substr(9, line.find(" #") - 9));
  }
  return examples;
}

TEST(DocExamples, Run) {
  const std::vector<std::string> examples = examples_in(STILLMAP_PAGE);
  EXPECT_GT(examples.size(), 10U);
  const TemporaryFolder folder;
  const std::string in_folder = "cd " + folder.path() + " && " + STILLMAP_EXECUTABLE;
  for (const std::string& example : examples) {
    const CommandResult result = run_command(in_folder, example);
    ASSERT_EQ(result.status, 0) << example << "\n" << result.output;
    std::cout << example << "\n" << result.output;
  }
  for (const char* file : {"clean.bag", "heights.png", "changes/diff.png", "why.png", "mended.stillmap"})
    EXPECT_GT(std::filesystem::file_size(folder.path(file)), 1000U) << file;
}

}  // namespace
}  // namespace stillmap
