// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(sheet_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

/// The damper of duty_test in SI units, with H = 1 m, omega = 1/s and 1000 kg, g = 10 m/s2:
/// friction of 7/24 m/s2, a notch of 1/4 J/kg.
const Arguments task(
    "region --velocity 1 --period 6.283185307179586 --gravity 10 --max-displacement 0.9 --f "
    "0.02916666666666667 --delta-m 25mm --tolerance 0.1 --sheet sheet.html");

/// The cells of the row of a table, and of its head, as "friction force, N | notch energy, J".
std::string told(const std::string& sheet, const std::string& heading) {
  const std::size_t from = sheet.find("<h2>" + heading + "</h2>");
  BOOST_TEST_REQUIRE(from != std::string::npos, heading);
  const std::string section = sheet.substr(from, sheet.find("</section>", from) - from);
  std::string text;
  bool tag = false;
  for (const char c : section) {
    tag = tag ? c != '>' : c == '<';
    if (c == '<' && !text.empty() && text.back() != '|') {
      text += '|';
    } else if (!tag && c != '>' && c != '\n') {
      text += c;
    }
  }
  for (std::size_t at = 0; (at = text.find("\u00a0", at)) != std::string::npos;) {
    text.replace(at, 2, " ");
  }
  return text;
}

void check_told(const std::string& sheet, const std::string& heading,
                const std::vector<std::string>& all) {
  const std::string text = told(sheet, heading);
  for (const std::string& part : all) {
    BOOST_TEST(contains(text, part), part << " in " << text);
  }
}

BOOST_AUTO_TEST_CASE(has_the_figures_worked_out_by_hand) {
  succeed(task + "--mass 1000");
  const std::string sheet = read("sheet.html");
  check_told(sheet, "Damper",
             {"friction force, kN|notch energy, kJ", "|least|0.263|0.225|", "|nominal|0.292|0.250|",
              "|most|0.320|0.275|"});
  check_told(sheet, "Stroke, speed and path",
             {"stroke, mm|worst stroke, mm|allowed, mm|peak velocity, m/s|slip path, mm",
              "|750|771.4|900|1|1500|"});  // sqrt(1 + (0.2625)^2) - 0.2625 = 0.77138
  check_told(sheet, "Energy and stiffness",
             {"friction heat, kJ|notch, kJ|secant stiffness, kN/m|equivalent damping, %|taken by a "
              "cycle, kJ",
              "|0.4375|0.0625|1.389|28.01|1.375|"});
}

BOOST_AUTO_TEST_CASE(has_only_units_that_were_given) {
  succeed(task);
  const std::string per_mass = read("sheet.html");
  check_told(per_mass, "Damper", {"friction per mass, m/s²|notch energy, J/kg", "|0.292|0.250|"});
  check_told(per_mass, "Energy and stiffness",
             {"secant stiffness, 1/s²", "|0.4375|0.0625|1.389|28.01|1.375|"});
  succeed("region --v0 1 --p 1 --beta 0.9 --f 0.2916666666666667 --delta 0.25 --sheet plain.html");
  const std::string plain = read("plain.html");
  check_told(plain, "Damper", {"friction f|notch energy Δ", "|0.292|0.250|"});
  check_told(plain, "Energy and stiffness",
             {"friction heat|notch|secant stiffness|", "|0.4375|0.0625|1.389|28.01|1.375|"});
  for (const char* unit : {"kN", ", J", ", mm", "m/s"}) {
    BOOST_TEST(!contains(plain.substr(plain.find("<body")), unit), unit);
  }
}

BOOST_AUTO_TEST_CASE(has_title_revision_and_a_date_that_can_be_fixed) {
  const auto at = [](const std::string& seconds) {
    return Surroundings{.environment = {{"SOURCE_DATE_EPOCH", seconds}}};
  };
  const Surroundings late = at("1000000000");  // 2001-09-09 01:46:40 UTC
  succeed(task + Arguments{"--title", "Tower <A>", "--revision", "C & D"}, late);
  const std::string sheet = read("sheet.html");
  BOOST_TEST(contains(sheet, "<h1>Tower &lt;A&gt;</h1>"));
  BOOST_TEST(contains(sheet, "Revision C &amp; D</span>"));
  BOOST_TEST(contains(sheet, "<span>2001-09-09</span>"));
  succeed(task, at("-1"));
  BOOST_TEST(contains(read("sheet.html"), "Revision <i></i></span> <span>1969-12-31</span>"));
  BOOST_TEST(contains(ending(2, task, at("soon")).err, "SOURCE_DATE_EPOCH"));
}

BOOST_AUTO_TEST_CASE(is_not_written_without_an_admissible_damper) {
  for (const char* command : {"design --v0 1 --p 1 --beta 0.5", "region --v0 1 --p 1 --beta 0.9",
                              "region --v0 1 --p 1 --beta 0.9 --f 0.3 --delta 0.0001"}) {
    const ProgramRun tried = run(Arguments(command) + "--sheet none.html");
    BOOST_TEST(tried.exit_code == run(command).exit_code, command);
    BOOST_TEST(contains(tried.err, "no sheet is written"), tried.err);
    BOOST_TEST(!fs::exists(path("none.html")));
  }
}

BOOST_AUTO_TEST_CASE(of_cases_has_a_row_for_each_and_what_governs) {
  const std::string scene = (fs::path(STILLPOINT_DATA_DIR) / "scenes/building.json").string();
  succeed({"design", scene, "--search-f", "0.04:0.041", "--sheet", "sheet.html"});
  const std::string sheet = read("sheet.html");
  check_told(sheet, "Stroke, speed and path", {"|service|", "|design|", "|maximum|"});
  check_told(sheet, "Limits", {"service governed by|", "maximum governed by|peak ≤ 450 mm"});
  BOOST_TEST(contains(sheet, "<svg"));
}

BOOST_AUTO_TEST_CASE(of_one_case_says_what_bounds_the_damper_itself) {
  succeed("design --v0 1 --p 1 --beta 5 --damping 5% --delta-max 0.1 --sheet sheet.html");
  check_told(read("sheet.html"), "Limits", {"|start|Δ ≤ 0.499999|", "|governs|Δ ≤ 0.1, "});
}

BOOST_AUTO_TEST_SUITE_END()
