// SPDX-License-Identifier: MIT
// What parts of a sweep are.
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/sweep/part.hpp>

BOOST_AUTO_TEST_SUITE(sweep_split_test)

using namespace stillpoint::sweep_test;

BOOST_AUTO_TEST_CASE(parts_cover_each_entry_once_and_are_equal_to_within_one) {
  constexpr std::int64_t most_entries = 1'000'000'000'000'000;
  std::mt19937_64 random(14);
  for (int i = 0; i < 200; ++i) {
    const std::int64_t count = 1 + static_cast<std::int64_t>(random() % 300);
    const auto entries = static_cast<std::int64_t>(random() % (i % 2 == 0 ? 500 : most_entries));
    std::int64_t next = 0;
    for (std::int64_t number = 1; number <= count; ++number) {
      const EntryRange range = range_of({number, count}, entries);
      BOOST_TEST_REQUIRE(range.first == next);
      BOOST_TEST_REQUIRE(range.count >= entries / count);
      BOOST_TEST_REQUIRE(range.count <= entries / count + 1);
      next += range.count;
    }
    BOOST_TEST_REQUIRE(next == entries);
  }
  const EntryRange last = range_of({most_sweep_parts, most_sweep_parts}, most_entries);
  BOOST_TEST(last.first + last.count == most_entries);
}

BOOST_AUTO_TEST_CASE(the_name_of_a_part_is_as_wide_as_that_of_the_last) {
  BOOST_TEST(with_part("rows.csv", {3, 8}) == "rows.csv");
  BOOST_TEST(with_part("{part}/{part}.csv", {3, 8}) == "3-of-8/3-of-8.csv");
  BOOST_TEST(with_part("a{part}", {3, 1000}) == "a0003-of-1000");
}

BOOST_AUTO_TEST_CASE(the_numbers_of_a_part_are_whole_in_any_form) {
  BOOST_TEST((parse_part("1e0/2") == SweepPart{1, 2}));
  BOOST_TEST((parse_part("3/1e3") == SweepPart{3, 1000}));
  for (const char* wrong : {"1.5/2", "1/2.5", "1/1e7", "2/1e0", "0e0/2", "/2", "1/", "1", "",
                            "1/2/3", "nan/2", "1/inf", "1/1e400"}) {
    BOOST_CHECK_THROW(static_cast<void>(parse_part(wrong)), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
