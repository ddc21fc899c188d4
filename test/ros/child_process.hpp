#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

namespace stillmap {

/// Most memory that a process ever had (VmHWM) or has now (VmRSS), MB; 0 when there is no such process.
inline double memory_mb(pid_t process, const std::string& which) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;)
    if (word == which + ":") {
      double kb = 0;
      status >> kb;
      return kb / 1024;
    }
  return 0;
}

/// A program beside the test, killed at the end of its life.
class ChildProcess {
 public:
  explicit ChildProcess(std::vector<std::string> command) : pid(fork()) {
    if (pid != 0) return;
    std::vector<char*> arguments;
    for (std::string& word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  ~ChildProcess() {
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  const pid_t pid;
};

}  // namespace stillmap
