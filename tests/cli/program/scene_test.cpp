// SPDX-License-Identifier: MIT
// Each scene of data/scenes works, and the text of its reports fits a terminal: the answer first,
// the rest on demand.
#include "cli_test.hpp"
#include "json_schema.hpp"

BOOST_FIXTURE_TEST_SUITE(scene_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

void check_width(const std::string& text) {
  constexpr std::size_t columns = 80;
  for (const std::string& line : lines_of(text)) {
    BOOST_TEST(line.size() <= columns, line);
  }
}

/// What design, or spectrum, answers in brief, in full and as JSON.
json check_answer(const Sandbox& sandbox, const Arguments& task, int exit_code) {
  constexpr std::size_t lines_at_most = 32;
  constexpr std::size_t lines_of_a_spectrum = 8;  // above that: a row for each period
  const std::string brief = sandbox.ending(exit_code, task + "--output report.json").out;
  const std::string full = sandbox.ending(exit_code, task + "--verbose").out;
  for (const std::string& text : {brief, full}) {
    check_width(text);
    check_only_finite(text);
  }
  const auto lines = lines_of(brief);
  BOOST_TEST(lines.size() <= lines_at_most + (task[0] == "spectrum" ? lines_of_a_spectrum : 0),
             brief);
  BOOST_TEST(lines.back() == "  --verbose shows more.");
  BOOST_TEST(lines_of(full).size() > lines.size());
  BOOST_TEST(!contains(full, "--verbose"));
  const std::string text = sandbox.read("report.json");
  check_only_finite(text);
  return json::parse(text);
}

BOOST_AUTO_TEST_CASE(shipped_with_the_project_all_work) {
  int scenes = 0;
  for (const fs::path& path : json_files("scenes")) {
    const std::string scene = path.string();
    const std::string name = path.filename().string();
    ++scenes;
    BOOST_TEST_CONTEXT(name) {
      const bool infeasible = name.starts_with("infeasible");
      const bool spectrum = name.starts_with("spectrum");
      Arguments task{spectrum ? "spectrum" : "design", scene};
      if (name == "building.json") {
        // pages_test searches all, for a minute under sanitizers
        task = task + "--search-f 0.04:0.041";
      }
      const json report = check_answer(*this, task, infeasible ? 3 : 0);
      BOOST_TEST((infeasible || spectrum || report["cross_check"]["passed"] == true));
      const json text = data_json(path);
      BOOST_TEST(text.contains("title"));
      // If a scene is not for region or simulate, these print nothing.
      const Arguments damper("--f 0.01 --delta 0.001 --verbose --output other.json");
      const ProgramRun motion = run(Arguments{"simulate", scene} + damper);
      check_width(motion.out);
      const ProgramRun region = run({"region", scene, "--verbose"});
      check_width(region.out);
      if (spectrum || text.contains("record")) {
        continue;
      }
      BOOST_TEST(region.exit_code == (infeasible ? 3 : 0));
      const bool closed_forms = !text.contains("damping");
      BOOST_TEST(report["region"].is_object() == closed_forms);
      BOOST_TEST((!closed_forms || report["region"]["feasible"] == !infeasible));
      const bool ranges =
          std::ranges::any_of(text, [](const json& value) { return value.is_array(); });
      BOOST_TEST(motion.exit_code == (ranges ? 2 : 0), motion.err);  // one motion has one hit
      if (!ranges) {
        BOOST_TEST(json::parse(read("other.json"))["input"]["excitation"].is_object() ==
                   text.contains("pulse"));
      }
    }
  }
  BOOST_TEST(scenes >= 6);
}

BOOST_AUTO_TEST_SUITE_END()
