// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(scene_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;
using right::with_input;

const std::string plain = R"({"v0": 1, "p": 1, "beta": 0.9, "tolerance": 0.1})";

}  // namespace

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

// The file beside the scene has half the load of the one in the working directory.
BOOST_AUTO_TEST_CASE(finds_its_files_beside_itself_then_in_the_working_directory) {
  fs::create_directories(path("job/records"));
  fs::create_directories(path("scenes"));
  write("job/records/a.txt", "0 0\n1 0.25\n2 0\n");
  write("a.txt", "0 0\n1 0.5\n2 0\n");
  const std::string task = R"("p": 1, "f": 0.01, "delta": 0})";
  write("job/beside.json", R"({"record": "records/a.txt", )" + task);
  write("job/above.json", R"({"record": "../job/./records/a.txt", )" + task);
  write("job/nested.json",
        R"({"excitation": {"type": "record", "record": "records/a.txt#1"}, )" + task);
  write("job/here.json", R"({"record": "a.txt", )" + task);
  const auto report = [&](const Arguments& arguments) {
    json found = reported("simulate" + arguments);
    return std::pair(found["input"]["excitation"]["record"].get<std::string>(), found["response"]);
  };
  const Arguments damper("--p 1 --f 0.01 --delta 0");
  const json near = report("--record job/records/a.txt" + damper).second;
  const json here = report("--record a.txt" + damper).second;
  BOOST_TEST(near != here);
  for (const char* const scene : {"job/beside.json", "job/above.json"}) {
    BOOST_TEST(report(scene).first == "job/records/a.txt");
    BOOST_TEST(report(scene).second == near);
  }
  BOOST_TEST(report("job/nested.json").second == near);
  BOOST_TEST(report("job/here.json").second == here);
  BOOST_TEST(report("job/beside.json --record a.txt").second == here);  // a flag is not the scene's
  check_refusal(
      run("simulate - --record-scale 2", with_input(R"({"record": "records/a.txt", )" + task)),
      {"records/a.txt: cannot be read"});
  write("job/parts.csv", "name,f,delta\na,0.26,0.37\n");
  write("job/parts.json", R"({"v0": 1, "p": 1, "beta": 0.9, "catalogue": "parts.csv"})");
  BOOST_TEST(reported("design job/parts.json")["design"]["name"] == "a");
  write("job/suite.csv", "file,scale\nrecords/a.txt,2\n");
  write("job/suite.json",
        R"({"records-list": "suite.csv", "p": 1, "beta": 9, "search-f": "0.1:0.1"})");
  BOOST_TEST(motion_of(reported("design job/suite.json"))["what"] == "job/records/a.txt");
  write("job/dampers.csv", "f,delta\n0.01,0\n");
  write("job/sweep.json", R"({"v0": 1, "p": 1, "list": "dampers.csv"})");
  BOOST_TEST(run("sweep job/sweep.json").exit_code == 0);
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
      const ProgramRun design =
          run({spectrum ? "spectrum" : "design", entry.path().string(), "--json"});
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
      BOOST_TEST(report["region"]["feasible"] == !infeasible);
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
