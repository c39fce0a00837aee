// SPDX-License-Identifier: MIT
#pragma once

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

namespace stillpoint::test {

/// The message of the error that reading throws.
template <class Error, class Read>
std::string refusal_of(const Read& read) {
  try {
    static_cast<void>(read());
  } catch (const Error& error) {
    return error.what();
  }
  BOOST_FAIL("was read");
  return {};
}

inline void check_says(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    BOOST_TEST(message.find(part) != std::string::npos, "no " << part << " in " << message);
  }
  BOOST_TEST(message.find('\n') == std::string::npos, message);
}

}  // namespace stillpoint::test
