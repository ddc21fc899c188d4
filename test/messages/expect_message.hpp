#pragma once

#include <gtest/gtest.h>

#include <string>

namespace stillmap {

/// The call throws Error, and its message holds the words.
template <class Error, class Call>
void expect_message(const Call& call, const std::string& words) {
  try {
    call();
    ADD_FAILURE() << "nothing was refused; expected: " << words;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

}  // namespace stillmap
