// SPDX-License-Identifier: MIT
// Findings are the same in every form of a report, and docs/reports.md lists them.
#include "cli_test.hpp"

#include <stillpoint/design/finding.hpp>

#include <fmt/format.h>

BOOST_FIXTURE_TEST_SUITE(findings_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using namespace stillpoint;

const std::string records =
    "--record " STILLPOINT_DATA_DIR "/records/near_fault_pulse.txt --record " STILLPOINT_DATA_DIR
    "/records/strong_motion.AT2 ";

const std::string scenes = STILLPOINT_DATA_DIR "/scenes/";

const std::string harmonic = "--excitation harmonic --k 0.3 --lambda 1 --t-end 20";

/// Tasks whose answers have findings of many kinds.
const std::vector<std::string> tasks{
    "design " + records + "--period 2.8s --max-displacement 25mm --tolerance 0",
    "design " + records + "--period 2.8s --search-f 2 --search-delta-m 0",
    "design " + records +
        "--period 2.8s --search-f 0.05 --search-delta-m 20mm --hold 0.1 "
        "--jump-max 5 --combine mean --max-displacement 400mm",
    "simulate --v0 0.1 --p 1 --f 0.02 --delta 0.1 " + harmonic,
    "simulate --p 1 --f 0.1 --delta 0.01 --excitation half-sine --k 0.3 --lambda 20",
    "simulate --period 2.8s --f 0.058 --delta-m 20mm --hold 0.1 " +
        records.substr(records.rfind("--")),
    "spectrum --period 2s:3s:3 --f 0.03 --delta-m 70mm --hold 0.1 " + records,
    "design " + scenes + "near_fault_pulse.json",
    "design " + scenes + "residual.json",
    "design " + scenes + "varying_hits.json --notch-width-m 1mm --acceleration-max 0.12",
    "design --v0 1 --p 1 --beta 0.9 --objective time",
    "design --v0 1 --p 1 --beta 0.70710679",
    "design --velocity 1.2 --period 0.1 --max-displacement 15mm",
    "design --pulse half-sine --k 0.4:0.5 --lambda 18:20 --p 1 --beta 0.05 --notch-width 0.02",
    "region --v0 0:1 --p 1 --beta 0.9 --f 0.3 --delta 0.3 --residual 0.1",
    "region --pulse full-sine --k 0.1 --lambda 1 --p 1 --beta 0.2 --f 0 --delta 0",
};

BOOST_AUTO_TEST_CASE(each_kind_is_listed_with_its_severity) {
  static const std::regex row(R"(\| `([a-z_]+)` \| (info|caution|fault) \| .+ \|)");
  std::map<std::string, std::string> listed;
  std::smatch match;
  for (const std::string& line : lines_of(text_of(STILLPOINT_DATA_DIR "/../docs/reports.md"))) {
    if (std::regex_match(line, match, row)) {
      listed[match[1]] = match[2];
    }
  }
  std::map<std::string, std::string> all;
  for (const auto& [kind, name] : enumerators(design::FindingKind())) {
    all[std::string(name)] = design::name(design::Finding(kind).severity);
  }
  BOOST_TEST(listed == all);
}

BOOST_AUTO_TEST_CASE(text_page_json_and_standard_error_say_the_same) {
  for (const std::string& task : tasks) {
    BOOST_TEST_CONTEXT(task) {
      const ProgramRun structured = run(Arguments(task.c_str()) + "--json");
      const json report = structured.json();
      const ProgramRun plain = run(Arguments(task.c_str()) + "--html page.html");
      const std::string text = one_line(plain.out);
      const std::string page = read("page.html");
      BOOST_TEST(!report["findings"].empty());
      BOOST_TEST(contains(text, report["verdict"].get<std::string>()), text);
      BOOST_TEST(report["verdict"].get<std::string>().size() <= 240U);
      BOOST_TEST(plain.err.empty(), plain.err);
      std::string alarms;
      for (const json& now : report["findings"]) {
        const auto words = now["text"].get<std::string>();
        const auto severity = now["severity"].get<std::string>();
        BOOST_TEST(contains(text, words), words);
        alarms += severity == "info" ? "" : fmt::format("stillpoint: {}: {}\n", severity, words);
      }
      BOOST_TEST(structured.err == alarms);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
