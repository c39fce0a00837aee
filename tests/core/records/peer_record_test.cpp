// SPDX-License-Identifier: MIT
#include "record_texts.hpp"

BOOST_AUTO_TEST_SUITE(peer_record_test)

using namespace stillpoint::test;

BOOST_TEST_DECORATOR(*boost::unit_test::tolerance(4 * std::numeric_limits<double>::epsilon()))
BOOST_AUTO_TEST_CASE(peer_record_is_read) {
  check_read("peer.txt", {"record.at2", "record.txt"});  // recognised by NPTS, not by its name
}

BOOST_AUTO_TEST_CASE(description_of_a_peer_record_is_its_titles) {
  BOOST_TEST(file_of("a.AT2", with_line_ends(header + three, "\r\n")).description ==
             "PEER NGA STRONG MOTION DATABASE RECORD; NOWHERE 01/02/03, SOME STATION, 090");
}

BOOST_AUTO_TEST_CASE(description_is_short_and_printable) {
  const auto described = [](const std::string& title) {
    return file_of("a.AT2", title + "\n" + quantity + "NPTS= 3, DT= .02 SEC\n" + three).description;
  };
  BOOST_TEST(described(std::string(999, 'x')) == std::string(200, 'x') + "...");
  BOOST_TEST(described("Ni\xC4\x9F-de") == "Ni\xC4\x9F-de");
  BOOST_TEST(described("Ni\xF0-de\fX") == "Ni?-de?X");
  // 1 + 2 * 100 bytes: the last letter does not fit.
  std::string letters = "x";
  for (int i = 0; i < 100; ++i) {
    letters += "\xC3\xA9";
  }
  BOOST_TEST(described(letters) == letters.substr(0, 199) + "...");
}

BOOST_AUTO_TEST_CASE(peer_record_is_refused) {
  check_refused("peer_wrong.txt", "record.AT2");
}

BOOST_AUTO_TEST_CASE(npts_stands_in_one_of_the_first_32_lines) {
  std::string text = "NPTS= 3, DT= .02 SEC\n" + three;
  for (int line = 1; line < 32; ++line) {
    text.insert(0, "A TITLE\n");
  }
  for (const char* name : {"a.AT2", "a.txt"}) {
    BOOST_TEST(record_of(name, text).values == plain, tt::per_element());
  }
  check_refused(
      "b.AT2",
      {.name = "", .text = "A TITLE\n" + text, .says = "line 32:...NPTS and DT are missing"});
  check_refused("b.txt", {.name = "",
                          .text = "A TITLE\n" + text,
                          .says = "line 2, column 1:...\"A\" is not a number"});
}

BOOST_AUTO_TEST_SUITE_END()
