// SPDX-License-Identifier: MIT
// Results are the same on every machine: a long double has 53, 64, 106 or 113 bits, and the last
// digits of the C library's functions differ. elementary.hpp and double_pair.hpp stand for them.
#include "sources.hpp"

BOOST_AUTO_TEST_SUITE(same_bits_everywhere_test)

using namespace stillpoint::test;

BOOST_AUTO_TEST_CASE(no_result_depends_on_the_c_library) {
  const std::regex depends(
      R"(long double|std::(sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot)\()");
  // The functions themselves where the C library has no choice; W(tau) as its formula says, for
  // figures and other integrators; what decides on a warning.
  const std::vector<std::string> may{"elementary.cpp", "excitation.hpp", "doubtful_values.cpp"};
  for (const fs::path& file : sources()) {
    const std::string name = file.lexically_relative(root).string();
    const bool computes = name.starts_with("core/") || name.starts_with("design/damper/") ||
                          name.starts_with("design/sweep/");
    if (!computes || std::ranges::count(may, file.filename().string()) > 0) {
      continue;
    }
    const std::string text = text_of(file);
    const std::sregex_iterator found(text.begin(), text.end(), depends);
    const std::string what = found == std::sregex_iterator() ? "" : found->str();
    BOOST_TEST(what == "", name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
