// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/report/document.hpp>

#include <regex>

BOOST_AUTO_TEST_SUITE(document_test)

using namespace stillpoint::report;

namespace {

using namespace stillpoint::test;

Document sample() {
  Document document;
  document.title = "Trial";
  document.verdict = "It holds.";
  Section& first = document.section("Rows");
  first.row("mass", "1 kg");
  first.row("", "of steel", Tone::good);
  Section& second = document.section("Table");
  second.parts.emplace_back(
      Table{{"", "size, mm", "is"}, {{{"a", "1", "met"}, Tone::good}, {{"long", "22", ""}}}});
  second.line("A note.");
  return document;
}

}  // namespace

BOOST_AUTO_TEST_CASE(as_text_is_aligned_columns) {
  BOOST_TEST(text(sample()) ==
             "Trial\n"
             "  It holds.\n"
             "\n"
             "Rows\n"
             "  mass              1 kg\n"
             "                    of steel\n"
             "\n"
             "Table\n"
             "         size, mm   is\n"
             "  a             1   met\n"
             "  long         22\n"
             "  A note.\n");
}

BOOST_AUTO_TEST_CASE(a_section_without_lines_has_no_heading) {
  Document document = sample();
  document.detail("Nothing");
  document.section("Nothing");
  BOOST_TEST(text(document) == text(sample()));
  BOOST_TEST(html(document) == html(sample()));
}

BOOST_AUTO_TEST_CASE(a_long_label_widens_the_column_of_its_section) {
  Document document;
  Section& counts = document.section("Counts");
  counts.row("never", "1");
  counts.row("not known to have stopped", "35");
  document.section("Rows").row("mass", "1 kg");
  const std::string written = text(document, {});
  BOOST_TEST(contains(written,
                      "  never                      1\n"
                      "  not known to have stopped  35\n"));
  BOOST_TEST(contains(written, "\n  mass              1 kg\n"));
}

BOOST_AUTO_TEST_CASE(a_wide_table_has_its_units_below) {
  Document document;
  const std::string wide(28, 'x');
  document.section("Wide").parts.emplace_back(
      Table{{"", "starts, s", wide, wide, "peak, mm"}, {{{"1", "0", "2", "3", "4"}}}});
  const std::string written = text(document, {});
  const std::string::size_type heads = written.find("  starts");
  BOOST_TEST_REQUIRE(heads != std::string::npos);
  const std::size_t next = written.find('\n', heads) + 1;
  BOOST_TEST(contains(written.substr(heads, next - heads), "peak\n"));
  BOOST_TEST(contains(written.substr(next, written.find('\n', next) + 1 - next), " s "));
  BOOST_TEST(!contains(written, "starts, s"));
}

BOOST_AUTO_TEST_CASE(words_at_the_end_of_a_row_continue_below_and_a_long_name_stands_above) {
  Document document;
  std::string why;
  for (int i = 0; i < 12; ++i) {
    why += "exceeds it; ";
  }
  document.section("Parts").parts.emplace_back(
      Table{{"part", "f", ""}, {{{"A", "0.5", why}}, {{"B", "0.25", "fits"}}}});
  const std::string name(30, 'n');
  Table records{{"record"}, {{{name}}}};
  for (int i = 0; i < 7; ++i) {
    records.head.emplace_back("x");
    records.rows[0].cells.emplace_back("1.23456");
  }
  document.section("Records").parts.emplace_back(records);
  const std::string written = text(document);
  BOOST_TEST(!std::regex_search(written, std::regex("[^\n]{81}")), written);
  BOOST_TEST(std::regex_search(written, std::regex("\n  A +0.5   exceeds it; .*\n {16}exceeds")),
             written);
  BOOST_TEST(contains(written, "\n  B      0.25   fits\n"), written);
  BOOST_TEST(contains(written, "\n  " + name + "\n          1.23456"), written);
}

/// If that is too narrow for their units, the words of heads stand in two lines.
BOOST_AUTO_TEST_CASE(heads_of_a_wide_table_break_between_words) {
  Document document;
  Table table{{""}, {{{"first"}}}};
  for (int i = 0; i < 8; ++i) {
    table.head.emplace_back(i % 2 == 0 ? "relative error" : "half-cycles");
    table.rows[0].cells.emplace_back("1.23");
  }
  document.section("Wide").parts.emplace_back(table);
  const std::string written = text(document);
  BOOST_TEST(contains(written, "         relative   half-  relative"), written);
  BOOST_TEST(contains(written, "            error  cycles     error"), written);
  BOOST_TEST(contains(written, "  first      1.23    1.23      1.23"), written);
}

BOOST_AUTO_TEST_CASE(as_html_is_tables_and_paragraphs) {
  BOOST_TEST(html(sample()) ==
             "<section><h2>Rows</h2>\n"
             "<div class=\"wide\"><table class=\"rows\">\n"
             "<tr><th>mass</th><td>1\u00a0kg</td></tr>\n"
             "<tr><th></th><td class=\"good\">of steel</td></tr>\n"
             "</table></div>\n</section>\n"
             "<section><h2>Table</h2>\n"
             "<div class=\"wide\"><table class=\"columns\">\n"
             "<thead><tr><th></th><th>size,\u00a0mm</th><th>is</th></tr></thead>\n"
             "<tr><td>a</td><td data-head=\"size\" data-unit=\"mm\">1</td><td data-head=\"is\" "
             "class=\"good\">met</td></tr>\n"
             "<tr><td>long</td><td data-head=\"size\" data-unit=\"mm\">22</td><td></td></tr>\n"
             "</table></div>\n"
             "<p>A note.</p>\n</section>\n");
}

/// Lines break between words, so that only the longest counts.
BOOST_AUTO_TEST_CASE(a_table_too_wide_for_half_a_page_goes_across) {
  const auto page = [](std::size_t letters) {
    Document document;
    document.section("Table").parts.emplace_back(
        Table{{"", "of some words"}, {{{"a b c d e f", std::string(letters, '1')}}}});
    return html(document);
  };
  BOOST_TEST(page(53).starts_with("<section><h2>"));
  BOOST_TEST(page(54).starts_with("<section class=\"across\"><h2>"));
}

/// Text in a document never brings in markup or control characters.
BOOST_AUTO_TEST_CASE(is_escaped) {
  Document document;
  document.section("<b>").row("&", "\"<script>\"");
  document.sections.back().line("<p>");
  document.sections.back().parts.emplace_back(Table{{"<i>"}, {{{"<td>"}}}});
  const std::string page = html(document);
  for (const char* markup : {"<b>", "<script>", "<p><p>", "<i>", "<td><td>"}) {
    BOOST_TEST(!contains(page, markup), page);
  }
  BOOST_TEST(contains(page, "&lt;script&gt;"), page);
  BOOST_TEST(text(sample(), {.title = "\x1b[2J"}).starts_with("Trial: \\x1b[2J\n"));
  BOOST_TEST(text(sample(), {.title = "\xC2\x9B[2J \xE2\x80\xAE"})
                 .starts_with("Trial: \\x9b[2J \\u202e\n"));
}

BOOST_AUTO_TEST_CASE(is_coloured_only_when_asked) {
  BOOST_TEST(!contains(text(sample()), "\x1b"));
  const std::string coloured = text(sample(), {.coloured = true});
  BOOST_TEST(contains(coloured, "\x1b[32mof steel\x1b[0m"), coloured);
}

BOOST_AUTO_TEST_CASE(long_lines_break_at_spaces) {
  Document document;
  std::string words;
  for (int i = 0; i < 60; ++i) {
    words += "word ";
  }
  document.section("Long").line(words + std::string(200, 'x'));
  std::istringstream lines(text(document));
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    BOOST_TEST((line.size() <= 98 || !contains(line, "word")), line);
    all += line.substr(line.find_first_not_of(' ') == std::string::npos ? 0 : 2) + " ";
  }
  BOOST_TEST(contains(all, words + std::string(200, 'x')), all);
}

/// A line ends within neither "f = 0.02" nor "5.9 mm".
BOOST_AUTO_TEST_CASE(no_line_break_separates_a_number_from_its_name_or_unit) {
  std::string verdict;
  for (int i = 0; i < 60; ++i) {
    verdict += std::string(static_cast<std::size_t>(i % 7) + 1, 'w') + " f = 0.02 of 5.9 mm, ";
  }
  Document document{.title = "t", .verdict = verdict};
  document.answer.row("label", verdict);
  document.section(verdict);
  std::istringstream lines(text(document));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    BOOST_TEST(line.size() <= 80U, line);
    BOOST_TEST((line.empty() || std::string("=0123456789").find(line.back()) == std::string::npos),
               line);
    BOOST_TEST((line.empty() || line.find_first_not_of(' ') != line.find('=')), line);
  }
  BOOST_TEST(count > 45U);
}

BOOST_AUTO_TEST_CASE(details_are_shown_on_request) {
  Document document{.title = "t", .verdict = "v"};
  document.section("shown").line("one");
  document.detail("hidden").line("two");
  const std::string brief = text(document);
  BOOST_TEST(contains(brief, "one"));
  BOOST_TEST(!contains(brief, "two"));
  BOOST_TEST(contains(brief, "--verbose"));
  const std::string full = text(document, {.verbosity = Verbosity::full});
  BOOST_TEST(contains(full, "two"));
  BOOST_TEST(!contains(full, "--verbose"));
}

BOOST_AUTO_TEST_SUITE_END()
