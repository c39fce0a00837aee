// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/records/file_error.hpp>

#include <cerrno>

BOOST_AUTO_TEST_SUITE(file_error_test)

using stillpoint::records::FileError;

BOOST_AUTO_TEST_CASE(message_begins_with_the_place) {
  const auto what = [](const FileError& error) { return std::string(error.what()); };
  BOOST_TEST(what(FileError({"scene", "a.json"}, "is empty")) == "scene a.json: is empty");
  BOOST_TEST(what(FileError({"list", "a.csv", 4}, "no f")) == "list a.csv, line 4: no f");
  BOOST_TEST(what(FileError({"list", "a.csv", 4, 7}, "no f")) ==
             "list a.csv, line 4, column 7: no f");
  BOOST_TEST(what(FileError::unreadable({"record", "a.AT2"}, ENOENT)) ==
             "record a.AT2: cannot be read: No such file or directory");
}

BOOST_AUTO_TEST_CASE(place_is_kept_whole_and_shown_in_part) {
  const std::string path(301, 'x');
  const FileError error({"record", path, 1}, "is wrong");
  BOOST_TEST(error.place().path == path);
  BOOST_TEST(*error.place().line == 1U);
  BOOST_TEST(!error.place().column.has_value());
  BOOST_TEST(error.what() == "record " + std::string(300, 'x') + "..., line 1: is wrong");
}

BOOST_AUTO_TEST_SUITE_END()
