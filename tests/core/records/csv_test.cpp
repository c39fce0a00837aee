// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/records/csv.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_suite.hpp>

#include "testing/folder.hpp"

BOOST_AUTO_TEST_SUITE(csv_test)

using namespace stillpoint::records;
using Fields = std::vector<std::string>;

std::string_view read_from(CsvRow& row, const Fields& lines) {
  auto line = lines.begin();
  return row.read(*line, [&](std::string_view& next) {
    ++line;
    next = line == lines.end() ? "" : std::string_view(*line);
    return line != lines.end();
  });
}

/// The fields of a row that has these lines.
Fields fields_of(const Fields& lines) {
  CsvRow row;
  BOOST_TEST(read_from(row, lines) == "");
  return {row.fields().begin(), row.fields().end()};
}

BOOST_AUTO_TEST_CASE(quotes_hold_commas_line_ends_and_doubled_quotes) {
  const std::vector<std::pair<Fields, Fields>> rows{
      {{"aaa,bbb,ccc"}, {"aaa", "bbb", "ccc"}},
      {{R"("aaa","bbb",ccc)"}, {"aaa", "bbb", "ccc"}},
      {{R"("aaa","b""bb","ccc")"}, {"aaa", R"(b"bb)", "ccc"}},
      {{R"("aaa","b)", R"(bb","ccc")"}, {"aaa", "b\nbb", "ccc"}},
      {{R"("a)", "", R"(")"}, {"a\n\n"}},
      {{R"("Slider 8"" disc",0.1)"}, {R"(Slider 8" disc)", "0.1"}},
      {{R"("""",",","")"}, {"\"", ",", ""}},
      {{"a,,"}, {"a", "", ""}},
      {{""}, {""}},
      {{" a b , \"c\" ,\t5\" pad"}, {"a b", "c", "5\" pad"}},
      {{R"(" a ")"}, {" a "}},
  };
  for (const auto& [lines, expected] : rows) {
    BOOST_TEST(fields_of(lines) == expected, tt::per_element());
  }
}

BOOST_AUTO_TEST_CASE(an_open_quote_and_text_behind_one_are_faults) {
  CsvRow row;
  BOOST_TEST(read_from(row, {"a,\"b,c", "d"}) == "a quote is opened but not closed");
  BOOST_TEST(read_from(row, {"a,\"b\" c"}) ==
             "text follows a closing quote; a quote within quotes must be doubled");
  BOOST_TEST(read_from(row, {"d"}) == "");
  BOOST_TEST((Fields(row.fields().begin(), row.fields().end()) == Fields{"d"}));
}

/// Whatever text fields have, it comes back from the quoted form.
BOOST_AUTO_TEST_CASE(random_fields_come_back) {
  constexpr unsigned seed = 36;
  std::mt19937 dice(seed);
  const auto below = [&](std::size_t most) { return dice() % most; };
  for (int i = 0; i < 2000; ++i) {
    Fields wanted(1 + below(5));
    std::string text;
    for (std::string& field : wanted) {
      for (std::size_t left = below(8); left > 0; --left) {
        field += "ab\" ,\n\xC3"[below(7)];
      }
      text += text.empty() && &field == wanted.data() ? "\"" : ",\"";
      for (const char c : field) {
        text += c == '"' ? std::string("\"\"") : std::string(1, c);
      }
      text += '"';
    }
    Fields lines{""};
    for (const char c : text) {
      if (c == '\n') {
        lines.emplace_back();
      } else {
        lines.back() += c;
      }
    }
    BOOST_TEST_CONTEXT("seed " << seed << ", row " << i << ": " << text) {
      BOOST_TEST(fields_of(lines) == wanted, tt::per_element());
    }
  }
}

BOOST_FIXTURE_TEST_CASE(a_list_of_records_has_such_rows, stillpoint::test::Folder) {
  write("list.csv",
        "# two\n\"file\",scale\r\n\"a, \"\"8\"\" disc.AT2\" , 2 \r\n\n\"b\nc.AT2\",\" -3\"\n");
  const auto list = read_record_list(path("list.csv"));
  BOOST_TEST_REQUIRE(list.size() == 2U);
  BOOST_TEST(list[0].path == "a, \"8\" disc.AT2");
  BOOST_TEST(list[0].scale == 2);
  BOOST_TEST(list[1].path == "b\nc.AT2");
  BOOST_TEST(list[1].scale == -3);
  const auto refusal = [&](const std::string& text) {
    write("wrong.csv", text);
    return stillpoint::test::refusal_of<FileError>(
        [&] { return read_record_list(path("wrong.csv")); });
  };
  BOOST_TEST(stillpoint::test::contains(refusal("file,scale\na.AT2,1\n\"b.AT2,2\nc.AT2,3\n"),
                                        ", line 3: a quote is opened but not closed"));
  BOOST_TEST(stillpoint::test::contains(
      refusal("file,scale\na, b.AT2,1\n"),
      ", line 2: must be FILE,NUMBER; a name with a comma must be in double quotes"));
}

BOOST_AUTO_TEST_SUITE_END()
