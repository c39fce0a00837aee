// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(scene_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using right::with_input;

const std::string plain = R"({"v0": 1, "p": 1, "beta": 0.9, "tolerance": 0.1})";

BOOST_AUTO_TEST_CASE(may_begin_with_a_dash_behind_two_dashes) {
  write("--json", plain);
  BOOST_TEST(succeed("design --beta 0.8 -- --json").out.starts_with("Damper design"));
  BOOST_TEST(run("design -- - ", with_input(plain)).exit_code == 0);
  BOOST_TEST(run("init -- machine").out == run("init machine").out);
  const Arguments whole("sweep --v0 1 --p 1 --f 0.1:0.2:4 --delta 0.1");
  succeed(whole + "--output whole.csv");
  succeed(whole + "--output=-1.csv --part 1/2");
  succeed(whole + "--output=-2.csv --part 2/2");
  for (const char* const merge :
       {"merge -- -m.csv -1.csv -2.csv", "merge m.csv -- -1.csv -2.csv"}) {
    succeed(Arguments{"sweep"} + merge);
  }
  BOOST_TEST(read("m.csv") == read("whole.csv"));
  BOOST_TEST(read("-m.csv") == read("whole.csv"));
}

BOOST_AUTO_TEST_CASE(can_hold_every_kind_of_option) {
  const std::string text = R"({"title": "by a scene", "v0": 1, "p": 1, "f": 0.02, "delta": 0.02,
      "max_half_cycles": 2, "trajectory": "motion.csv", "samples": 3, "json": true,
      "output": "report.json"})";
  const ProgramRun answer = succeed("simulate -", with_input(text));
  BOOST_TEST(answer.json()["half_cycles_listed"] == 2);
  BOOST_TEST(read("report.json") == answer.out);
  BOOST_TEST(!read("motion.csv").empty());
  const ProgramRun titled = run("design -", with_input(R"({"title": "the old bridge", "v0": 1,
      "p": 1, "beta": 0.9, "json": false})"));
  BOOST_TEST(titled.out.starts_with("Damper design: the old bridge\n"));
}

BOOST_AUTO_TEST_CASE(shipped_with_the_project_all_work) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(STILLPOINT_DATA_DIR "/scenes")) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    ++scenes;
    BOOST_TEST_CONTEXT(entry.path().filename()) {
      const std::string name = entry.path().filename().string();
      const bool infeasible = name.starts_with("infeasible");
      const bool spectrum = name.starts_with("spectrum");
      Arguments task{spectrum ? "spectrum" : "design", entry.path().string(), "--json"};
      if (name == "building.json") {
        task = task +
               "--search-f 0.04:0.041";  // pages_test searches all, for a minute under sanitizers
      }
      const ProgramRun design = run(task);
      BOOST_TEST(design.exit_code == (infeasible ? 3 : 0));
      check_only_finite(design.out);
      const json report = design.json();
      BOOST_TEST((infeasible || spectrum || report["cross_check"]["passed"] == true));
      std::ifstream file(entry.path());
      const json text = json::parse(file);
      BOOST_TEST(text.contains("title"));
      if (spectrum || text.contains("record")) {
        continue;
      }
      const bool closed_forms = !text.contains("damping");
      BOOST_TEST(report["region"].is_object() == closed_forms);
      BOOST_TEST((!closed_forms || report["region"]["feasible"] == !infeasible));
      const ProgramRun motion =
          run({"simulate", entry.path().string(), "--f", "0.01", "--delta", "0.001", "--json"});
      const bool ranges =
          std::ranges::any_of(text, [](const json& value) { return value.is_array(); });
      BOOST_TEST(motion.exit_code == (ranges ? 2 : 0), motion.err);  // one motion has one hit
      if (!ranges) {
        BOOST_TEST(motion.json()["input"]["excitation"].is_object() == text.contains("pulse"));
      }
      const ProgramRun region = run({"region", entry.path().string(), "--json"});
      BOOST_TEST(region.exit_code == (infeasible ? 3 : 0));
    }
  }
  BOOST_TEST(scenes >= 6);
}

BOOST_AUTO_TEST_SUITE_END()
