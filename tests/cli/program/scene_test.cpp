// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(scene_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

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
