// SPDX-License-Identifier: MIT
#pragma once

#include "testing/contains.hpp"

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
  check_contains(message, parts);
  BOOST_TEST(!contains(message, "\n"), message);
}

}  // namespace stillpoint::test
