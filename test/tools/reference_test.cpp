// doc/reference.md is what the code says.

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

TEST(Reference, IsWhatTheCommandPrints) {
  TemporaryFolder folder;
  const std::string printed = folder.path("reference.md");
  ASSERT_EQ(std::system((STILLMAP_COMMAND " reference > " + printed).c_str()), 0);
  EXPECT_EQ(read_text(printed), read_text(STILLMAP_REFERENCE))
      << "make it anew: stillmap reference > doc/reference.md";
}

}  // namespace
}  // namespace stillmap
