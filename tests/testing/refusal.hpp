// SPDX-License-Identifier: MIT
#pragma once

// What a call says of wrong input.

#include "testing/contains.hpp"

#include <stillpoint/core/input_error.hpp>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <string>
#include <vector>

namespace stillpoint::test {

/// The message of the Error that `call` throws; empty, with a failure, where it throws none.
template <class Error>
std::string refusal_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  BOOST_ERROR("nothing was thrown");
  return {};
}

/// An InputError of `field`, which its message names first.
inline void check_refused(const std::string& field, const std::function<void()>& call) {
  try {
    call();
    BOOST_ERROR(field << " was taken");
  } catch (const InputError& error) {
    BOOST_TEST(error.field() == field);
    BOOST_TEST(std::string(error.what()).starts_with(field), error.what());
  }
}

/// The field that an InputError of `call` names; empty where it throws none.
inline std::string refused_field(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.field();
  }
  return {};
}

inline void check_says(const std::string& message, const std::vector<std::string>& parts) {
  check_contains(message, parts);
  BOOST_TEST(!contains(message, "\n"), message);
}

}  // namespace stillpoint::test
