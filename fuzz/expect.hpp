#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace stillmap::fuzz {

/// Ends the program, which the fuzzer takes as a find, unless it is so.
inline void expect(bool is_so, const char* what) {
  if (is_so) return;
  std::fprintf(stderr, "fuzz: not so: %s\n", what);
  std::abort();
}

/// The call may do its work or refuse it with a std::runtime_error or std::invalid_argument that holds `name`
/// and says more than that. Whatever else is thrown ends the program.
template <class Call>
void expect_named_refusal(const std::string& name, Call&& call) {
  const auto check = [&](const std::string& message) {
    if (message.find(name) == std::string::npos || message.size() < name.size() + 5)
      std::fprintf(stderr, "fuzz: the refusal is: %s\n", message.c_str());
    expect(message.find(name) != std::string::npos, "a refusal names the file or value");
    expect(message.size() >= name.size() + 5, "a refusal says what is wrong");
  };
  try {
    call();
  } catch (const std::runtime_error& error) {
    check(error.what());
  } catch (const std::invalid_argument& error) {
    check(error.what());
  }
}

}  // namespace stillmap::fuzz
