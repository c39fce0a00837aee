// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fmt/format.h>

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <numbers>
#include <regex>

BOOST_AUTO_TEST_SUITE(record_design_command_test)

// design --record, from the flags to the report. The search itself is in record_design_test.

namespace {

using namespace stillpoint::cli_test;

/// Of a figure worked out by hand, after its way through metres.
constexpr double hand_tolerance = 1e-12;

/// A damper that does not move, so every figure is known: it transmits the load.
const Arguments held("design --record a.txt --period 2.8s --search-f 2:2 --search-delta-m 0:0");

/// A search under it takes seconds.
const Arguments long_search(
    "design --record long.txt --record-step 0.01 --period 2.8 --hold 0.1 --jump-max 9");
std::string long_record(int shaken = 18'900) {
  std::string record;
  for (int i = 0; i < shaken + 1100; ++i) {
    // Without an offset, and quiet at its end.
    record += i >= shaken ? "0\n" : i % 7 < 3 ? "0.3\n" : "-0.225\n";
  }
  return record;
}

json failed_report(const Sandbox& sandbox, const Arguments& arguments, int exit_code) {
  const ProgramRun answer = sandbox.run(arguments + "--json");
  BOOST_TEST(answer.exit_code == exit_code, answer.err);
  return answer.json();
}

const std::vector<Wrong> wrong_inputs{
    {"design --velocity 0.4 --period 2 --record a.txt",
     {"velocity and records cannot be combined"}},
    {"design --record b.txt --period 2", {"b.txt"}},
    {"design --record a.txt --max-displacement 0.2", {"period"}},
    {"design --record a.txt --period 2 --catalogue parts.csv",
     {"catalogue cannot be used in a design under records"}},
    {"design --record a.txt --period 2 --trade-off 5",
     {"trade-off cannot be used in a design under records"}},
    {"design --record a.txt --period 2 --scan-points 0", {"scan-points", "0", "from 1"}},
    {"design --record a.txt --period 2 --search-f -0.1", {"search-f = -0.1", "from 0"}},
    {"design --record a.txt --period 2 --search-f 0.2:0.1", {"search-f = 0.2:0.1", "LOW <= HIGH"}},
    {"design --record a.txt --period 2 --search-delta-m -1mm:1mm",
     {"search-delta-m", "LOW <= HIGH"}},
    {"design --record a.txt --search-period 0:2", {"search-period"}},
    {"design --record a.txt --period 1:4", {"period = 1:4", "must be one number with records"}},
    {"design --record a.txt --stiffness 1:2 --mass 1t", {"stiffness = 1:2", "search-period"}},
    {"design --record a.txt --p 1:2", {"p = 1:2", "must be one number with records"}},
    {"design --record a.txt --period 2 --objective robust", {"max-displacement", "give a limit"}},
    {"design --record a.txt --period 2 --objective time", {"objective = time", "under records"}},
    {"design --record a.txt --period 2 --search-delta-m 1mm:2mm",
     {"search-delta-m", "--search-notch-width-m", "--jump-max"}},
    {"design --record a.txt --period 2 --notch-width-m 1mm --jump-max 1", {"jump-max"}},
    {"design --record a.txt --period 2 --notch-width-m 1mm --search-notch-width-m 1mm:2mm",
     {"cannot be combined"}},
    {"design --record a.txt --period 2 --tolerance-f 0.8:0.9", {"tolerance-f = 0.8:0.9", "<= 1"}},
    {"design --v0 1 --p 1 --beta 0.9 --tolerance-period 0.1",
     {"tolerance-period needs a design under records"}},
    {"design --v0 1 --p 1 --beta 0.9 --objective residual", {"objective = residual", "records"}},
    {"design --record a.txt --period 2 --combine median", {"combine = median", "max or mean"}},
    {"design --record a.txt --period 2 --arrivals 2",
     {"arrivals cannot be used in a design under records"}},
    {"design --v0 1 --p 1 --beta 0.9 --combine max", {"combine needs a design under records"}},
    {"design --v0 1 --p 1 --beta 0.9 --combine mean",
     {"combine needs a design under records: give --record as well"}},
    {"design --records-list bare.csv --period 2", {"records-list bare.csv, line 1", "file,scale"}},
    {"design --records-list word.csv --period 2", {"records-list word.csv, line 2", "scale"}},
    {"design --records-list zero.csv --period 2", {"records-list zero.csv, line 2", "scale"}},
    {"design --records-list empty.csv --period 2", {"records-list empty.csv", "no record"}},
    {"design --record a.txt --period 2 --record-step 0.01",
     {"record-step = 0.01 s: must not be given: each record has times or a step of its own"}},
    {"design --record a.txt --period 2 --acceleration-max 0", {"acceleration-max = 0"}},
    {"design --record a.txt --period 2 --residual-m -1", {"residual-m = -1"}},
    {"design --record a.txt --period 2 --tolerance 1", {"tolerance = 1"}},
    {"design --record a.txt --period 2 --hold 1 --notch-width 1", {"cannot be combined"}},
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(a_damper_that_does_not_move_transmits_the_load, Recorded) {
  // As a spreadsheet may save it.
  write("list.csv", "\xEF\xBB\xBF\"file\", scale\r\n\"a.txt\" , -3 \r\n# a comment\r\n \r\n");
  for (const auto& [combine, load] : {std::pair{"max", 1.2}, {"mean", 0.8}}) {
    const json report =
        reported(held + "--records-list list.csv" + Arguments{"--combine", combine});
    check_values(report["design"], {{"f", 2}, {"delta_m", 0}});
    BOOST_TEST(near(report["design"]["period_s"], 2.8, hand_tolerance));
    BOOST_TEST(report["input"]["objective"] == "acceleration");
    BOOST_TEST(report["cases"][0]["combine"] == combine);
    BOOST_TEST(
        near(report["cases"][0]["worst"]["peak_absolute_acceleration"], load, hand_tolerance));
    BOOST_TEST(report["cross_check"]["passed"] == true);
  }
  // The mean hides the record that is beyond it.
  const std::string mean =
      one_line(run(held + "--records-list list.csv --combine mean --quiet").out);
  BOOST_TEST(contains(mean, "Mean of 2 records, worst within the tolerance: 0.8 g "), mean);
  check_contains(run(held).out, {"\n                    The friction is more than the weight: "});
  const std::string rows = one_line(run(held + "--records-list list.csv --combine mean").out);
  BOOST_TEST(contains(rows, " worst record -3 x a.txt: 1.2 g transmitted"), rows);
}

BOOST_FIXTURE_TEST_CASE(a_limit_of_the_mean_is_not_drawn_as_one_of_a_record, Recorded) {
  for (const auto& [combine, drawn] : {std::pair{"max", true}, {"mean", false}}) {
    succeed(Arguments{"design", "--record", "a.txt", "--combine", combine} +
            "--period 2.8s --search-f 0.3:0.3 --search-delta-m 0:0 --max-displacement 20mm "
            "--tolerance 0 --html p.html");
    BOOST_TEST(contains(read("p.html"), ">limit 20 mm<") == drawn, combine);
  }
}

/// Friction of 0.3996 lets go for an instant under 0.4 g.
BOOST_FIXTURE_TEST_CASE(a_stroke_that_nobody_can_measure_has_no_digits, Recorded) {
  const std::string text =
      one_line(run("design --record a.txt --period 2.8s --search-delta-m 0:0 --search-f "
                   "0.3996:0.3996 --tolerance 0")
                   .out);
  check_contains(text, {" g transmitted, stroke less than 0.001 mm, residual less than 0.001 mm.",
                        " a.txt 0.4 <0.001 <0.001 "});
}

// m f g = 1000 kg x 0.3 x 9.80665 m/s2 and m g Delta = 1000 kg x 9.80665 m/s2 x 1 mm.
BOOST_FIXTURE_TEST_CASE(a_mass_gives_the_force_and_the_energy_of_the_damper, Recorded) {
  const Arguments asked(
      "design --record a.txt --period 2.8s --search-f 0.3:0.3 --search-delta-m 1mm:1mm "
      "--notch-width-m 20mm");
  const json with = run(asked + "--mass 1t --json").json()["physical"];
  constexpr double few_ulps = 1e-14;
  BOOST_TEST(std::abs(with["friction_force_n"].get<double>() / 2941.995 - 1) <= few_ulps);
  BOOST_TEST(std::abs(with["energy_per_passage_j"].get<double>() / 9.80665 - 1) <= few_ulps);
  const json without = run(asked + "--json").json()["physical"];
  BOOST_TEST(without["friction_force_n"].is_null());
  BOOST_TEST(without["energy_per_passage_j"].is_null());
}

/// Friction of 2 holds it against 0.4 and 1.2 g: |0.4 - 2|/(0.4 + 2) = 67 % and 0.8/3.2 = 25 %.
BOOST_FIXTURE_TEST_CASE(the_report_names_the_motion_nearest_to_another_outcome, Recorded) {
  write("list.csv", "file,scale\na.txt,1\na.txt,-3\n");
  const Arguments one(
      "design --record a.txt --period 2.8s --search-f 2:2 --search-delta-m 0:0 --verbose");
  BOOST_TEST(contains(run(one).out, "\n  decision margin   67 %\n"), run(one).out);
  const std::string two = one_line(run(held + "--records-list list.csv --verbose").out);
  check_contains(two, {" decision margin 25 %, under -3 x a.txt "});
}

/// By what holds it when its load ends.
BOOST_FIXTURE_TEST_CASE(each_way_to_rest_is_named, Recorded) {
  const auto rest = [&](const Arguments& more) {
    return one_line(run(Arguments("design --record a.txt --period 2.8s --verbose") + more).out);
  };
  const std::string friction = rest("--search-f 2:2 --search-delta-m 0:0");
  check_contains(
      friction, {" rest by friction to the end of the record ", " 0.4 0 by friction Not required: ",
                 " tried f 1.8 to 2.2: no failure in 4001 dampers, corners and boundary included"});
  const std::string notch =
      rest("--search-f 0.02:0.02 --search-delta-m 1mm:1mm --hold 10 --jump-max 1");
  check_contains(notch,
                 {" rest by the notch to the end of the record ", " 0.4 0 by notch Not required: ",
                  " tried f 0.018 to 0.022, delta 0.9 mm to 1.1 mm: no failure in 4000 dampers"});
  // The last second of its load cannot stop a mass with next to no friction.
  const std::string later = rest("--search-f 0.01:0.01 --search-delta-m 0:0");
  check_contains(later, {" rest after the load of the record ", " after load Not required: "});
  check_contains(
      rest("--search-f 2:2 --search-delta-m 0:0 --tolerance 0"),
      {" No other damper was tried: one that is not exactly this one may do anything. "});
  // The load is over before the record is.
  write("quiet.txt", "0 0.4\n1 -0.2\n2 0\n3 0\n40 0\n");
  const std::string over = one_line(
      run("design --record quiet.txt --record a.txt --record-scale 1 --period 2.8s --search-f "
          "0.01:0.01 --search-delta-m 0:0")
          .out);
  BOOST_TEST(contains(over, " rest after the load of every record "), over);
}

BOOST_FIXTURE_TEST_CASE(a_damper_that_locks_is_reported, Recorded) {
  const ProgramRun answer =
      run("design --record a.txt --period 2.8s --search-f 0.02:0.02 --search-delta-m 1mm:1mm "
          "--jump-max 1 "
          "--hold 10");
  check_contains(
      one_line(answer.out),
      {" The damper found has f = 0.02 and delta = 1 mm in a notch that lets go at 10 g above the "
       "friction, with a period of 2.8 s. Under the record, worst within the tolerance: 0.4 g "
       "transmitted. ",
       " caution The mass never moves: it is held through the record, and the structure feels up "
       "to 0.4 g. "});
  BOOST_TEST(contains(answer.out, "passed: Runge-Kutta agrees exactly\n"), answer.out);
  BOOST_TEST(answer.err.empty(), answer.err);
}

// Friction and notch let go of the mass for an instant, and what it feels is the load of the lock.
BOOST_FIXTURE_TEST_CASE(a_lock_is_below_the_headline, Sandbox) {
  const std::string record = STILLPOINT_DATA_DIR "/records/strong_motion.AT2";
  const Arguments asked{"design", "--record", record, "--period", "2.8", "--scan-points", "1"};
  const auto text = [&](const Arguments& more) { return one_line(run(asked + more).out); };
  const std::string held = text(
      "--search-f 0.038069:0.038069 --search-delta-m 13.444mm:13.444mm --jump-max 5 --tolerance 0");
  check_contains(held, {" Under the record: 0.35 g transmitted",
                        " caution The notch locks the mass to the end of the record; the structure "
                        "then feels up to 0.35 g."});
  const std::string wide = text(
      "--search-f 0.0106721:0.0106721 --search-delta-m 0.895464mm:0.895464mm "
      "--notch-width-m 20mm --tolerance 0");
  check_contains(
      wide, {" g transmitted, stroke ", " caution The notch locks the mass to the end of the "});
}

BOOST_FIXTURE_TEST_CASE(records_may_be_dimensionless, Recorded) {
  const json report =
      reported("design --record a.txt --p 1 --beta 1 --search-f 2:2 --residual 0.1");
  BOOST_TEST(report["design"]["delta_m"] == nullptr);
  BOOST_TEST(near(report["cases"][0]["worst"]["peak_absolute_acceleration"], 0.4, hand_tolerance));
}

BOOST_FIXTURE_TEST_CASE(a_step_is_for_the_records_without_one, Recorded) {
  write("values.txt", "0\n0.9\n0\n");
  const json report = reported(held + "--record values.txt --record-step 0.5");
  BOOST_TEST(near(motion_of(report)["pga"], 0.4, hand_tolerance));
  BOOST_TEST(near(report["cases"][0]["motions"][1]["pga"], 0.9, hand_tolerance));
}

BOOST_FIXTURE_TEST_CASE(the_report_matches_simulate, Recorded) {
  const json report = reported(
      "design --record a.txt --period 2.8 --max-displacement 0.3 --residual-m 5mm --hold 0.1 "
      "--jump-max 2");
  const json& design = report["design"];
  const json motion =
      reported({"simulate", "--record", "a.txt", "--period", "2.8", "--hold", "0.1", "--f",
                in_full(design["f"]), "--delta-m", in_full(design["delta_m"])});
  const json& response = motion["response"];
  BOOST_TEST(
      near(report["cases"][0]["nominal"]["peak_amplitude"], response["peak_amplitude"], 1e-9));
  BOOST_TEST(near(report["cases"][0]["nominal"]["peak_absolute_acceleration"],
                  response["peak_absolute_acceleration"], 1e-9));
  BOOST_TEST(report["cases"][0]["worst"]["peak_amplitude"] >=
             report["cases"][0]["nominal"]["peak_amplitude"]);
  const json& worst = report["cases"][0]["worst"]["of"]["peak_amplitude"];
  const json at_worst =
      reported({"simulate", "--record", "a.txt", "--period", "2.8", "--hold", "0.1", "--f",
                in_full(worst["f"]), "--delta-m", in_full(worst["delta_m"])});
  BOOST_TEST(near(report["cases"][0]["worst"]["peak_amplitude"],
                  at_worst["response"]["peak_amplitude"], 1e-9));
  BOOST_TEST(motion_of(report)["response"]["outcome"] == response["outcome"]);
  BOOST_TEST(report["cases"][0]["worst"]["peak_m"].get<double>() <= 0.3);
  BOOST_TEST(report["cases"][0]["worst"]["residual_m"].get<double>() <= 0.005);
  const json& box = design["box"];
  BOOST_TEST(box["samples"].get<int>() >= 4000);
  BOOST_TEST(box["exact"] == false);
  BOOST_TEST(near(box["f"][0], 0.9 * design["f"].get<double>(), hand_tolerance));
  BOOST_TEST(box["period_s"].is_null());
  BOOST_TEST(near(report["input"]["residual_m"], 0.005, hand_tolerance));
}

BOOST_FIXTURE_TEST_CASE(the_period_is_a_third_variable, Recorded) {
  const json report = reported(
      "design --record a.txt --search-period 1s:3s --search-f 2:2 "
      "--search-delta-m 0:1mm --jump-max 1 --threads 1");
  BOOST_TEST(report["design"]["period_s"].get<double>() >= 1 - hand_tolerance);
  BOOST_TEST(report["design"]["period_s"].get<double>() <= 3 + hand_tolerance);
  const std::string text =
      run("design --record a.txt --search-period 1s:3s --search-f 0.1:0.1 --search-delta-m 0:0 "
          "--threads 1 --verbose")
          .out;
  BOOST_TEST(contains(text, "\n  period searched   1 to 3 s\n"), text);
  BOOST_TEST(contains(text, "period of 3 s, the longest that was searched"), text);
}

BOOST_FIXTURE_TEST_CASE(without_a_damper_it_says_which_limit_is_in_the_way, Recorded) {
  const json report =
      failed_report(*this, held + "--max-displacement 10mm --acceleration-max 0.1", 3);
  BOOST_TEST(report["design"] == nullptr);
  BOOST_TEST(report["verdict"].is_string());
  const json& limits = report["constraints"];
  BOOST_TEST_REQUIRE(limits.size() == 2U);
  check_values(limits[0], {{"name", "amplitude"}, {"relation", "<="}, {"motion", "a.txt"}});
  check_values(limits[1], {{"name", "acceleration"}, {"satisfied", false}});
  BOOST_TEST(near(limits[1]["value"], 0.4, hand_tolerance));
  BOOST_TEST(near(limits[0]["limit_m"], 0.01, hand_tolerance));
  check_null(limits[1], {"value_m", "limit_m"});
  BOOST_TEST_REQUIRE(report["mends"].size() == 1U);
  BOOST_TEST(report["mends"][0]["input"] == "acceleration_max");
  const std::string relaxed = in_full(report["mends"][0]["value"]);
  succeed(held + Arguments{"--max-displacement", "10mm", "--acceleration-max", relaxed});
  const std::string text = run(held + "--max-displacement 10mm --acceleration-max 0.1").out;
  BOOST_TEST(contains(text, "No damper was found that meets the limits within its tolerance; the "),
             text);
}

/// Friction above the load holds it, so that the structure feels the peak of 0.4 g.
BOOST_FIXTURE_TEST_CASE(without_a_damper_the_map_names_the_limit_to_relax, Recorded) {
  const ProgramRun none = ending(3,
                                 "design --record a.txt --period 2.8 --search-f 1:2 "
                                 "--search-delta-m 0:1mm --jump-max 1 --scan-points "
                                 "100 --acceleration-max 0.1 --html p.html");
  const std::string page = read("p.html");
  check_contains(
      page, {">No damper: allow 0.4", "Each area is named after the limit exceeded most there"});
}

/// Up to f = 0.4, from where on it locks and feels 0.4 g, 300 % too much, it moves by less than
/// 2 mm, 100 % too far.
BOOST_FIXTURE_TEST_CASE(a_map_names_the_limit_that_is_exceeded_most, Recorded) {
  ending(3,
         "design --record a.txt --period 2.8 --search-f 0.35:1 --search-delta-m 0:1mm "
         "--jump-max 1 --tolerance 0 --scan-points 100 --acceleration-max 0.1 --max-displacement "
         "1mm --html p.html");
  const std::string page = read("p.html");
  BOOST_TEST(contains(page, ">transmits too much</text>"));
  BOOST_TEST(!contains(page, ">stroke too large</text>"));
  BOOST_TEST(!contains(page, "300 % to 300 %"));  // most of them are in one shade
}

/// On a knife edge: six digits give a sixth of the stroke.
BOOST_FIXTURE_TEST_CASE(the_nearest_damper_does_what_is_said_of_it_as_printed, Sandbox) {
  const Arguments load{"--record", STILLPOINT_DATA_DIR "/records/strong_motion.AT2", "--period",
                       "2.8"};
  const std::string text = one_line(
      run(Arguments("design --max-displacement 2mm --acceleration-max 0.05 --tolerance 0") + load)
          .out);
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(
      text, found,
      std::regex("nearest f = (\\S+), delta = 0, .* stroke (\\S+) mm; 2 mm is allowed")));
  const json motion = reported(Arguments{"simulate", "--f", found[1], "--delta-m", "0"} + load);
  const double peak = 1000 * motion["physical"]["peak_m"].get<double>();
  BOOST_TEST(fmt::format("{:.5g}", peak) == found[2].str());
}

BOOST_FIXTURE_TEST_CASE(a_damper_without_friction_is_reported_never_to_rest, Recorded) {
  const json report = failed_report(*this,
                                    "design --record a.txt --period 2.8 --search-f 0:0 "
                                    "--search-delta-m 0:0 --max-displacement 1",
                                    3);
  BOOST_TEST(report["nearest"]["worst"] == nullptr);
  BOOST_TEST_REQUIRE(report["constraints"].size() == 1U);
  check_null(report["constraints"][0], {"value", "value_m", "slack"});
}

BOOST_FIXTURE_TEST_CASE(a_scene_lists_its_records, Recorded) {
  write("b.txt", "0 0.1\n1 0\n");
  write("scene.json",
        R"({"record": ["a.txt", "b.txt"], "period": "2.8s", "search_f": "2:2",
            "search-delta-m": "0:0mm"})");
  BOOST_TEST(reported("design scene.json")["cases"][0]["motions"].size() == 2U);
  BOOST_TEST(reported("design scene.json --record b.txt")["cases"][0]["load"]["records"] == 1);
  // For a hit, the records are those of another command.
  const ProgramRun hit = run("design scene.json --velocity 0.4 --max-displacement 0.15 --json");
  BOOST_TEST(hit.json()["schema"] == "stillpoint/design-report/2");
  BOOST_TEST(contains(hit.err, "note: record in the scene is not used by design"), hit.err);
}

/// A passage with v and a stop with v change the velocity by v - sqrt(v^2 - 2 delta) and v at once,
/// which no acceleration counts.
BOOST_FIXTURE_TEST_CASE(the_jumps_that_an_acceleration_leaves_out_are_beside_it, Sandbox) {
  const Arguments given{"--record", STILLPOINT_DATA_DIR "/records/near_fault_pulse.txt", "--period",
                        "2.8s"};
  const Arguments judged =
      "design --max-displacement 1m --search-f 0.05:0.05 --search-delta-m 50mm:50mm --mass 1t "
      "--tolerance 0" +
      given;
  const json motion = run("simulate --f 0.05 --delta-m 50mm --json --hold 0.1" + given).json();
  double jump = 0;
  for (const json& now : motion["half_cycles"]) {
    if (const json& impulse = now["impulse"]; !impulse.is_null()) {
      jump = std::max(jump, impulse.get<double>());
    }
  }
  const double speed = jump * motion["physical"]["velocity_unit_m_per_s"].get<double>();
  check_contains(
      one_line(run(judged + "--hold 0.1 --jump-max 9").out),
      {fmt::format(
          " caution At the notch the velocity jumps by up to {:.4g} m/s; the accelerations "
          "leave these jumps out. ",
          speed)});
  BOOST_TEST(!contains(run(judged + "--notch-width-m 50mm").out, "jumps"));
}

BOOST_FIXTURE_TEST_CASE(text_and_page_show_each_record, Recorded) {
  const Arguments asked(
      "design --record a.txt --period 2.8 --max-displacement 0.3 --residual-m 0.005 --html p.html");
  const ProgramRun answer = succeed(asked);
  std::string page = read("p.html");
  check_contains(one_line(answer.out), {" note No notch was searched: without a width "});
  const Arguments holds = asked + "--hold 0.1 --jump-max 2";
  const std::string held_up = one_line(run(holds).out);
  check_contains(held_up,
                 {" mm in a notch that lets go at 0.1 g above the friction, with a period "});
  check_contains(held_up, {" At the notch the velocity jumps by up to "});
  check_contains(one_line(run(holds + "--mass 1t").out),
                 {" and a notch that lets go at 0.1 g above the friction and takes "});
  BOOST_TEST(contains(answer.out, "a.txt"));
  succeed(holds);
  page = read("p.html");
  check_contains(page, {"id=\"map-title\"", "id=\"record-1-title\"", "chosen", "a.txt",
                        "The transmitted acceleration over f and Δ", "<th>peak,\u00a0mm</th>"});
}

BOOST_FIXTURE_TEST_CASE(each_motion_of_a_page_has_its_load_below_it, Recorded) {
  write("list.csv", "file,scale\na.txt,1\na.txt,0.3\na.txt,-1\n");
  succeed(
      "design --records-list list.csv --period 2.8 --search-f 0.1:0.1 --search-delta-m 1mm:1mm "
      "--jump-max 5 --html p.html");
  const std::string page = read("p.html");
  std::size_t at = 0;
  for (const char* const id : {"worst", "worst-load", "record-2", "record-2-load", "record-3",
                               "record-3-load", "spectrum-acceleration"}) {
    const std::size_t next = page.find(std::string("id=\"") + id + "-title\"");
    BOOST_TEST((next != std::string::npos && next > at), id);
    at = next;
  }
}

BOOST_FIXTURE_TEST_CASE(the_areas_of_the_map_bear_values_between_those_of_the_key, Sandbox) {
  succeed(
      Arguments{"design", "--record", STILLPOINT_DATA_DIR "/records/near_fault_pulse.txt"} +
      "--period 2.8 --max-displacement 0.4 --notch-width-m 50mm --scan-points 400 --html p.html");
  std::string page = read("p.html");
  page.resize(page.find("id=\"map-near-title\""));  // whose areas have another key
  const auto values = [&page](const char* before) {
    const std::regex number(before + std::string("([0-9.]+) g<"));
    std::vector<double> found;
    for (std::sregex_iterator at(page.begin(), page.end(), number), end; at != end; ++at) {
      found.push_back(std::stod((*at)[1]));
    }
    return found;
  };
  BOOST_TEST(contains(page, "where it is hatched, the darker, the more the limits are exceeded"));
  const std::vector<double> areas = values(">≈ ");
  BOOST_TEST(!areas.empty());
  for (const double value : areas) {
    BOOST_TEST(values(">from ").at(0) < value);
    BOOST_TEST(value < values(">to ").at(0));
  }
}

BOOST_FIXTURE_TEST_CASE(an_interrupt_ends_with_the_best_so_far, Sandbox) {
  write("long.txt", long_record());
  const Surroundings interrupted{.interrupt = true};
  const ProgramRun stopped = ending(130, long_search + "--json --output r.json", interrupted);
  BOOST_TEST(stopped.err ==
             "stillpoint: caution: The search was interrupted: a complete one may find a better "
             "damper.\n");
  BOOST_TEST(stopped.json()["search"]["interrupted"] == true);
  BOOST_TEST(stopped.json()["search"]["scan"]["points"] < 10'000);
  BOOST_TEST(read("r.json") == stopped.out);
  BOOST_TEST(contains(run(long_search, interrupted).out,
                      "No damper was verified before the search was interrupted."));
}

// Friction alone is verified in a second; the notch of any width, at any period, takes a minute.
BOOST_FIXTURE_TEST_CASE(an_interrupt_gives_the_verified_damper_that_a_terminal_shows, Sandbox,
                        *boost::unit_test::precondition(if_terminals)) {
  write("shorter.txt", long_record(2'900));
  const Arguments search(
      "design --record shorter.txt --record-step 0.01 --search-period 2:4 --residual-m 0.05 "
      "--search-notch-width-m 20mm:300mm --scan-points 1000000");
  const std::string mark = ", best verified ";
  const Surroundings interrupted{.error_is_terminal = true, .interrupt_at = mark};
  const ProgramRun stopped = ending(130, search + "--json --output r.json", interrupted);
  check_contains(stopped.err, {" of about ", " dampers"});
  const json report = stopped.json();
  BOOST_TEST(report["search"]["interrupted"] == true);
  BOOST_TEST(report["design"]["box"]["samples"] >= 4000);
  BOOST_TEST(report["cases"][0]["worst"]["residual_m"] <= 0.05);
  BOOST_TEST(read("r.json") == stopped.out);

  const ProgramRun again = ending(130, search, interrupted);
  BOOST_TEST(contains(again.out, "The best damper so far has f = "), again.out);
  const std::string best = again.err.substr(again.err.rfind(mark) + mark.size());
  const std::string transmitted = best.substr(0, best.find(','));  // "0.24 g"
  BOOST_TEST(contains(one_line(again.out), " " + transmitted + " transmitted"), again.out);
}

BOOST_DATA_TEST_CASE_F(Recorded, wrong_input_is_refused, data::make(wrong_inputs), wrong) {
  write("bare.csv", "a.txt,1\n");
  write("word.csv", "file,scale\na.txt,one\n");
  write("zero.csv", "file,scale\na.txt,0\n");
  write("empty.csv", "file,scale\n");
  check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
