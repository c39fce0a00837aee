// SPDX-License-Identifier: MIT
#include "browser.hpp"
#include "pages.hpp"

#include <zlib.h>

// The pages as the program wrote them, untouched, on paper.

namespace {

using namespace stillpoint;
using namespace stillpoint::browser_test;

/// The contents of a PDF stream; empty if it is not deflated.
std::string inflated(const std::string& packed) {
  std::string plain(std::size_t{1} << 22U, '\0');
  uLongf size = plain.size();
  const int status = ::uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                                  reinterpret_cast<const Bytef*>(packed.data()),
                                  static_cast<uLong>(packed.size()));
  plain.resize(status == Z_OK ? size : 0);
  return plain;
}

/// The drawing of all pages.
std::string drawing(const std::string& pdf) {
  static const std::regex begin("[^d]stream\r?\n");
  std::string text;
  for (std::sregex_iterator at(pdf.begin(), pdf.end(), begin), end; at != end; ++at) {
    const auto from = static_cast<std::size_t>(at->position() + at->length());
    text += inflated(pdf.substr(from, pdf.find("endstream", from) - from));
  }
  return text;
}

/// The PDF of a page.
std::string printed(const std::string& page, const cli_test::Arguments& options = {}) {
  const auto& sandbox = pages().sandbox;
  const Visit visited =
      visit(sandbox, page + ".html",
            cli_test::Arguments{"--print-to-pdf=" + sandbox.path(page + ".pdf").string(),
                                "--no-pdf-header-footer"} +
                options);
  BOOST_TEST(visited.exit_code == 0);
  BOOST_TEST(visited.console.empty(), visited.console);
  return sandbox.read(page + ".pdf");
}

auto count(const std::string& text, const std::string& pattern) {
  const std::regex form(pattern);
  return std::distance(std::sregex_iterator(text.begin(), text.end(), form), {});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(printing)

BOOST_AUTO_TEST_CASE(gives_a_few_light_pages) {
  for (const auto& [name, report] : pages().reports) {
    BOOST_TEST_CONTEXT(name) {
      const std::string pdf = printed(name, {"--blink-settings=preferredColorScheme=0"});
      BOOST_TEST(pdf.starts_with("%PDF-"));
      BOOST_TEST(pdf.size() > 10'000U);
      BOOST_TEST(pdf.size() < 1'000'000U);
      const auto sheets = count(pdf, R"(/Type /Page\b)");
      BOOST_TEST(sheets >= 1);
      // The figures begin below the answer, and a table does not leave its last rows for a sheet.
      BOOST_TEST(sheets <= (name == "spectrum" ? 1 : name == "forced" ? 2 : 4));
      const std::string drawn = drawing(pdf);
      BOOST_TEST(count(drawn, R"(\.1333\d* \.1333\d* \.1333\d* rg)") > 0);   // #222, text
      BOOST_TEST(count(drawn, R"(\.0784\d* \.0941\d* \.1137\d* rg)") == 0);  // #14181d, paper
    }
  }
}

/// Of a hit, with units and without, of a pulse, of records and of cases, where a search takes
/// long.
BOOST_AUTO_TEST_CASE(gives_at_most_two_pages_of_a_specification) {
  const auto& sandbox = pages().sandbox;
  for (const char* const name :
       {"isolator", "plain", "pulse", "records", "near_fault_pulse", "building"}) {
    BOOST_TEST_CONTEXT(name) {
      const std::string scene = std::string(STILLPOINT_DATA_DIR) + "/scenes/" + name + ".json";
      if (std::string_view(name) == "building") {
        sandbox.succeed({"region", scene, "--f", "0.04", "--delta-m", "29mm", "--notch-width-m",
                         "295mm", "--sheet", "sheet.html"});
      } else {
        sandbox.succeed({"design", scene, "--sheet", "sheet.html"});
      }
      const auto sheets = count(printed("sheet"), R"(/Type /Page\b)");
      BOOST_TEST(sheets >= 1);
      BOOST_TEST(sheets <= 2);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
