#include "tools/plot_report.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

namespace stillmap {

void plot_report(const std::string& report_folder) {
  namespace fs = std::filesystem;
  std::string script = (fs::read_symlink("/proc/self/exe").parent_path() / "plot_report.py").string();
  std::string folder = report_folder;
  char* const arguments[] = {script.data(), folder.data(), nullptr};
  pid_t process = 0;
  int status = 0;
  const bool ran = posix_spawn(&process, script.c_str(), nullptr, nullptr, arguments, environ) == 0 &&
                   waitpid(process, &status, 0) == process;
  if (ran && WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw std::runtime_error(script + ": did not run through, so " + report_folder +
                           " has its tables but no figures; it needs python3-matplotlib (--no-figures "
                           "leaves them out)");
}

}  // namespace stillmap
