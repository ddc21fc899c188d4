#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace stillmap {

/// The call is refused, and the message holds each of the words.
template <class Error = std::runtime_error, class Call>
void expect_error(Call&& call, std::initializer_list<std::string> words) {
  try {
    call();
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    const std::string message = error.what();
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' is not in: " << message;
  }
}

}  // namespace stillmap
