// SPDX-License-Identifier: MIT
#pragma once

// What a failed BOOST_TEST(a == b) prints of enumerators and of values that may be absent.

#include <boost/test/unit_test.hpp>

#include <concepts>
#include <optional>
#include <ostream>
#include <string_view>
#include <type_traits>

namespace stillpoint::test {

template <class Value>
concept Named = requires(Value value) {
  { name(value) } -> std::convertible_to<std::string_view>;
};

}  // namespace stillpoint::test

namespace boost::test_tools::tt_detail {

/// The name that the library gives it, or its number.
template <class Enum>
requires std::is_enum_v<Enum>
struct print_log_value<Enum> {
  void operator()(std::ostream& out, Enum value) const {
    if constexpr (stillpoint::test::Named<Enum>) {
      out << name(value);
    } else {
      out << "enumerator " << static_cast<long long>(value);
    }
  }
};

template <class Value>
struct print_log_value<std::optional<Value>> {
  void operator()(std::ostream& out, const std::optional<Value>& value) const {
    if (value) {
      print_log_value<Value>{}(out, *value);
    } else {
      out << "nothing";
    }
  }
};

}  // namespace boost::test_tools::tt_detail
