// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/report/document.hpp>

BOOST_AUTO_TEST_SUITE(document_test)

using namespace stillpoint::report;
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
  document.brief = true;
  const std::string brief = text(document);
  BOOST_TEST(contains(brief, "one"));
  BOOST_TEST(!contains(brief, "two"));
  BOOST_TEST(contains(brief, "--verbose"));
  document.brief = false;
  const std::string full = text(document);
  BOOST_TEST(contains(full, "two"));
  BOOST_TEST(!contains(full, "--verbose"));
}

BOOST_AUTO_TEST_SUITE_END()
