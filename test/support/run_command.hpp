#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "support/temporary_folder.hpp"

namespace stillmap {

/// What a command line said and how it ended.
struct CommandResult {
  int status = -1;
  std::string output;  ///< stdout and stderr
};

/// Runs it to its end.
inline CommandResult run_command(const std::string& executable, const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string log = folder.path("log.txt");
  const int status = std::system((executable + " " + arguments + " >" + log + " 2>&1").c_str());
  return {WEXITSTATUS(status), read_text(log)};
}

}  // namespace stillmap
