// SPDX-License-Identifier: MIT
// What C's functions make of the digits of a number depends on the locale of the host, which may
// write 0,5. The sources read numbers with std::from_chars.
#include "sources.hpp"

BOOST_AUTO_TEST_SUITE(plain_numbers_test)

using namespace stillpoint::test;

BOOST_AUTO_TEST_CASE(no_number_is_read_by_the_locale) {
  for (const fs::path& file : sources()) {
    const std::string text = text_of(file);
    for (const char* reads : {"stod(", "stof(", "stold(", "strtod(", "strtof(", "strtold(", "atof(",
                              "scanf(", "lexical_cast<"}) {
      BOOST_TEST(text.find(reads) == std::string::npos, file.lexically_relative(root).string()
                                                            << " calls " << reads);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
