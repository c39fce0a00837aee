// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/sweep/axis.hpp>

BOOST_AUTO_TEST_SUITE(sweep_axis_test)

using namespace stillpoint::sweep_test;

std::vector<double> values_of(const std::string& text) {
  const Axis axis = parse_axis("f", text);
  std::vector<double> values;
  for (std::int64_t i = 0; i < axis.size(); ++i) {
    values.push_back(axis[i]);
  }
  return values;
}

BOOST_AUTO_TEST_CASE(has_the_numbers_of_its_text) {
  BOOST_TEST((values_of("3") == std::vector<double>{3}));
  BOOST_TEST((values_of("3,-4,7e-1") == std::vector<double>{3, -4, 0.7}));
  BOOST_TEST((values_of("0:1:5") == std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  BOOST_TEST((values_of("1:0:3") == std::vector<double>{1, 0.5, 0}));
  BOOST_TEST((values_of("0.1:0.1:1") == std::vector<double>{0.1}));
}

BOOST_AUTO_TEST_CASE(logarithmic_range_has_equal_ratios_and_exact_ends) {
  const std::vector<double> values = values_of("1e-3:1e1:5:log");
  // The nearest doubles, as the numbers of the source are.
  BOOST_TEST((values == std::vector<double>{1e-3, 1e-2, 1e-1, 1e0, 1e1}));
}

BOOST_AUTO_TEST_CASE(text_reads_back) {
  for (const std::string text : {"3", "3,-4,0.7", "0:1:5", "0.001:0.35:3000", "1:10:7:log"}) {
    BOOST_TEST(parse_axis("f", text).text() == text);
  }
}

BOOST_AUTO_TEST_CASE(ranges_have_two_ends_of_which_one_stands_for_them) {
  const auto number = [](std::string_view text) { return std::stod(std::string(text)); };
  const Axis hits = parse_axis("v0", "1,0.9:1.1,0:2", number, RangeEnd::high);
  BOOST_TEST_REQUIRE(hits.size() == 3);
  BOOST_TEST_REQUIRE(hits.has_ranges());
  BOOST_TEST((hits[0] == 1 && hits[1] == 1.1 && hits[2] == 2));
  const Axis low = hits.other_ends();
  BOOST_TEST((low.size() == 3 && low[0] == 1 && low[1] == 0.9 && low[2] == 0));
  BOOST_TEST(hits.text() == "1:1,0.9:1.1,0:2");
  const Axis springs = parse_axis("p", "0.9:1.1", number, RangeEnd::low);
  BOOST_TEST((springs[0] == 0.9 && springs.other_ends()[0] == 1.1));
  BOOST_TEST(springs.text() == "0.9:1.1");
  BOOST_TEST(!parse_axis("v0", "0:1:5", number, RangeEnd::high).has_ranges());
  BOOST_TEST(!parse_axis("v0", "1,2", number, RangeEnd::high).has_ranges());
  BOOST_TEST(parse_axis("v0", "-0:0", number, RangeEnd::high).text() == "0:0");
  BOOST_CHECK_THROW(static_cast<void>(parse_axis("v0", "1:2,0:1:5", number, RangeEnd::high)),
                    InputError);
}

BOOST_AUTO_TEST_CASE(knows_its_ends_and_spacing) {
  const auto [least, most] = parse_axis("f", "3,-4,7").ends();
  BOOST_TEST(least == -4);
  BOOST_TEST(most == 7);
  BOOST_TEST(!parse_axis("f", "3,4").spacing());
  BOOST_TEST((parse_axis("f", "1:2:3").spacing() == Axis::Spacing::linear));
  BOOST_TEST((parse_axis("f", "1:2:3:log").spacing() == Axis::Spacing::logarithmic));
}

BOOST_AUTO_TEST_CASE(wrong_text_is_refused_with_the_field) {
  for (const std::string text :
       {"", "a", "1:2", "1:2:0", "1:2:2.5", "1:2:3:cubic", "0:1:3:log", "1,,2", "nan",
        "-1e308:1e308:3", "1:2:1e16", "1:2:1", "1:2:1:log"}) {
    test::check_refused("f", [&] { return parse_axis("f", text); });
  }
}

BOOST_AUTO_TEST_SUITE_END()
