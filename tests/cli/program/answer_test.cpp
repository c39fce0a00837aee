// SPDX-License-Identifier: MIT
// The text of a report: the answer first, short enough for a terminal, the rest on demand.
#include "cli_test.hpp"

#include <stillpoint/report/digits.hpp>

BOOST_AUTO_TEST_SUITE(answer_test)

using namespace stillpoint::cli_test;

constexpr std::size_t columns = 80;
constexpr std::size_t lines_at_most = 32;
constexpr std::size_t lines_of_a_spectrum = 8;  ///< above that: a row for each period

BOOST_FIXTURE_TEST_CASE(of_each_scene_fits_a_terminal, Sandbox) {
  for (const auto& entry : fs::directory_iterator(STILLPOINT_DATA_DIR "/scenes")) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    const bool spectrum = entry.path().filename().string().starts_with("spectrum");
    const char* const command = spectrum ? "spectrum" : "design";
    const std::string text = run({command, entry.path().string()}).out;
    const auto lines = lines_of(text);
    BOOST_TEST(lines.size() <= lines_at_most + (spectrum ? lines_of_a_spectrum : 0), text);
    BOOST_TEST(lines.back() == "  --verbose shows more.");
    for (const std::string& line : lines) {
      BOOST_TEST(line.size() <= columns, line);
    }
    const std::string full = run({command, entry.path().string(), "--verbose"}).out;
    BOOST_TEST(lines_of(full).size() > lines.size());
    BOOST_TEST(!contains(full, "--verbose"));
    // If a scene is not for region or simulate, these print nothing.
    const std::string region = run({"region", entry.path().string(), "--verbose"}).out;
    const std::string motion = run({"simulate", entry.path().string(), "--verbose", "--f", "0.02",
                                    contains(full, " mm") ? "--delta-m" : "--delta", "0.001"})
                                   .out;
    for (const std::string& text_of_all : {full, region, motion}) {
      for (const std::string& line : lines_of(text_of_all)) {
        BOOST_TEST(line.size() <= columns, entry.path() << ": " << line);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
