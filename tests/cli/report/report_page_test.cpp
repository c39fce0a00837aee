// SPDX-License-Identifier: MIT
#include "drawn_pages.hpp"

#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/digits.hpp>

BOOST_AUTO_TEST_SUITE(report_page_test)

using namespace stillpoint;
using namespace stillpoint::report;
using namespace stillpoint::test;

/// The three formats agree: the numbers of the JSON are in the text and on the page.
BOOST_AUTO_TEST_CASE(text_page_and_json_agree) {
  const DesignReport report = isolator_report();
  const auto data = json(report);
  const std::string plain = text(document(report));
  const figures::HtmlPage made = page(report);
  const auto& physical = data["physical"];
  for (const std::string& value :
       {digits(data["design"]["f"].get<double>()), with_unit(physical["delta_m"], "m"),
        with_unit(physical["peak_m"], "m"), limit_digits(data["region"]["f3"], false, 6)}) {
    BOOST_TEST(contains(plain, value), plain);
    BOOST_TEST(contains(made.answer + made.body, figures::prose(value)), made.answer);
  }
  BOOST_TEST(contains(plain, made.verdict.substr(0, 40)), plain);
  for (const auto& constraint : data["constraints"]) {
    const auto name = constraint["name"].get<std::string>();
    BOOST_TEST(contains(made.body, name == "dead_zone" ? "dead zone" : name));
  }
}

/// A browser applies a policy only to what stands behind it.
BOOST_AUTO_TEST_CASE(a_page_may_load_nothing) {
  const std::string file = figures::html(isolator());
  const std::size_t policy = file.find(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
      "'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; ");
  BOOST_TEST_REQUIRE(policy != std::string::npos, file.substr(0, 500));
  for (const char* const begin : {"<title", "<style", "<script", "<body", "<image", "<link"}) {
    BOOST_TEST(file.find(begin) > policy, begin);
  }
  BOOST_TEST(!std::regex_search(file, std::regex("(src|href)=\"(?!data:|#)")));
}

BOOST_AUTO_TEST_CASE(a_mass_at_rest_has_no_figures) {
  const HtmlPage made = page_of(simulation_of({1, 0.1, 1}, {0, 0.1}));  // v0^2 < 2 delta
  BOOST_TEST(made.figures.empty());
  BOOST_TEST(contains(made.verdict, "never starts"), made.verdict);
}

BOOST_AUTO_TEST_SUITE_END()
