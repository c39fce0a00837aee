// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/records/text.hpp>

BOOST_AUTO_TEST_SUITE(text_test)

using namespace stillpoint::records;

/// In UTF-8; code < 0x10000.
std::string encoded(unsigned code) {
  const auto byte = [](unsigned bits) { return static_cast<char>(bits); };
  return code < 0x80U ? std::string(1, byte(code))
         : code < 0x800U
             ? std::string{byte(0xC0U | (code >> 6U)), byte(0x80U | (code & 0x3FU))}
             : std::string{byte(0xE0U | (code >> 12U)), byte(0x80U | ((code >> 6U) & 0x3FU)),
                           byte(0x80U | (code & 0x3FU))};
}

bool is_within(unsigned code, unsigned first, unsigned last) {
  return first <= code && code <= last;
}

BOOST_AUTO_TEST_CASE(controls_and_marks_of_direction_are_replaced_and_nothing_else_is) {
  for (unsigned code = 0; code < 0xD800U; ++code) {
    const bool is_control = is_within(code, 0, 0x1F) || is_within(code, 0x7F, 0x9F) ||
                            is_within(code, 0x200B, 0x200F) || is_within(code, 0x2028, 0x202E) ||
                            is_within(code, 0x2066, 0x2069);
    const std::string text = "a" + encoded(code) + "\xC3\xBC";
    unsigned found = code;
    const std::string changed = with_controls_as(
        [&](unsigned control) {
          found = control;
          return "<>";
        },
        text);
    if (changed != (is_control ? "a<>\xC3\xBC" : text) || found != code ||
        printable(text, 9) != (is_control ? "a?\xC3\xBC" : text)) {
      BOOST_ERROR("U+" << std::hex << code << " gives " << changed);
    }
  }
}

BOOST_AUTO_TEST_CASE(bytes_that_are_no_utf_8_are_controls_where_latin_1_has_them) {
  const auto marked = [](const std::string& text) {
    return with_controls_as([](unsigned code) { return "<" + std::to_string(code) + ">"; }, text);
  };
  BOOST_TEST(marked("a\x9B"
                    "2J") == "a<155>2J");
  BOOST_TEST(marked("Gr\xFC\xDF") == "Gr\xFC\xDF");
  BOOST_TEST(marked("\xE2\x80") == "\xE2<128>");
  BOOST_TEST(printable("Gr\xFC\x9B", 9) == "Gr??");
}

BOOST_AUTO_TEST_SUITE_END()
