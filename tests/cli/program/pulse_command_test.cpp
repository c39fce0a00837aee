// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <regex>

BOOST_FIXTURE_TEST_SUITE(pulse_command_test, stillpoint::cli_test::Sandbox)

// design --pulse and region --pulse, from the flags to the report.

namespace {

using namespace stillpoint::cli_test;

const Arguments asked("design --pulse half-sine --k 0.5 --lambda 20 --p 1 --beta 0.05");

/// docs/theory.md section 8: f from 0.1 to 0.25, with the peak 1 - 2 f.
const Arguments region("region --pulse rectangle --k 0.5 --lambda 1 --p 1 --beta 0.8");

/// Without the option and its value.
Arguments without(Arguments arguments, const std::string& option) {
  const auto found = std::ranges::find(arguments, option);
  BOOST_REQUIRE(found != arguments.end());
  arguments.erase(found, found + 2);
  return arguments;
}

}  // namespace

/// Friction alone is a damper, but it leaves the mass off centre.
BOOST_AUTO_TEST_CASE(without_a_notch_nothing_stops_the_mass_at_the_centre) {
  const Arguments design("design --pulse rectangle --k 0.5 --lambda 1 --p 1 --beta 0.8");
  const Arguments varies("design --pulse half-sine --k 0.4:0.5 --lambda 1 --p 1 --beta 1");
  const Arguments physical(
      "design --pulse half-sine --k 5g --pulse-duration 11ms --natural-frequency 10Hz "
      "--max-displacement 4mm");
  for (const Arguments& task : {design + "--delta-max 0", varies + "--delta-max 0",
                                physical + "--delta-max-m 0", region + "--delta-max 0"}) {
    const json report = json::parse(ending(3, task + "--json").out);
    check_contains(report["region"]["reason"].get<std::string>(),
                   {"without a notch (delta = 0) the mass rests up to f/p^2 off centre"});
    BOOST_TEST(report["region"]["conflict"] == json::array({"stop", "delta_max"}));
  }
  write("parts.csv", "name,f,delta\nplain,0.15,0\n");
  const json choice = json::parse(ending(3, design + "--catalogue parts.csv --json").out);
  BOOST_TEST(choice["catalogue"][0]["admissible"] == false);
  BOOST_TEST(choice["catalogue"][0]["violates"][0]["name"] == "stop");
}

BOOST_AUTO_TEST_CASE(report_says_how_the_design_stands_under_its_pulse) {
  const json report = reported(asked);
  BOOST_TEST(report["schema"] == "stillpoint/design-report/2");
  check_values(report["input"], {{"pulse", "half-sine"}, {"k", 0.5}, {"lambda", 20}});
  BOOST_TEST(report["region"]["by"] == "forced_motion");
  BOOST_TEST(report["region"]["delta2"].is_null());
  const json& pulse = report["pulse"];
  BOOST_TEST(motion_of(report)["what"] == "half-sine");
  BOOST_TEST(report["input"]["v0"] == pulse["equivalent_v0"]);
  BOOST_TEST(pulse["shortness"] == 0.05);
  BOOST_TEST(pulse["warnings"].empty());
  // docs/forced.md section 8
  BOOST_TEST(pulse["peak_error"].get<double>() > 0.21 * 0.0025);
  BOOST_TEST(pulse["peak_error"].get<double>() < 0.31 * 0.0025);
}

/// The width that the limit of the acceleration alone asks for, 0.0971, would hold the mass.
BOOST_AUTO_TEST_CASE(no_report_recommends_a_notch_that_holds_the_mass) {
  const Arguments design(
      "design --pulse rectangle --k 0.5 --lambda 1 --p 1 --beta 0.8 --delta-max 0.1 "
      "--acceleration-max 1.2");
  const json report = reported(design);
  const double f = report["design"]["f"];
  const double delta = report["design"]["delta"];
  const double width = report["practice"]["notch_width_min"];
  BOOST_TEST(near(width, delta / (0.5 - f), 1e-12));
  const auto built = [&](double wide) {
    return reported(design +
                    Arguments{"--notch-width", in_full(wide)})["built_notch"]["motion"]["response"];
  };
  BOOST_TEST(built(width)["peak_amplitude"].get<double>() > 0);
  BOOST_TEST(built(0.999 * width)["peak_amplitude"] == 0);
}

/// Under f + delta/w at the start.
BOOST_AUTO_TEST_CASE(a_notch_as_narrow_as_the_report_says_holds_the_mass) {
  const double width = finding(reported(asked), "no_notch_works")["least_width"];
  const auto peak = [&](double share) {
    const json report =
        run(asked + Arguments{"--notch-width", in_full(share * width), "--json"}).json();
    return report["built_notch"]["motion"]["response"]["peak_amplitude"].get<double>();
  };
  BOOST_TEST(peak(0.999) == 0);
  BOOST_TEST(peak(1.001) > 0);
}

BOOST_AUTO_TEST_CASE(cross_check_has_the_pulse_and_an_integrator) {
  const json report = reported(asked);
  std::vector<std::string> names;
  for (const json& method : report["cross_check"]["methods"]) {
    names.push_back(method["name"]);
    BOOST_TEST(method["passed"] == true);
  }
  BOOST_TEST((names == std::vector<std::string>{"forced_pulse", "runge_kutta"}));
}

// Known by hand, docs/theory.md section 15. The rectangle with the largest peak is the strongest.
BOOST_AUTO_TEST_CASE(ranges_of_a_pulse_are_in_the_report) {
  const Arguments ranged(
      "design --pulse rectangle --k 0.45:0.55 --lambda 1 --p 1 --beta 0.9 --criterion exact");
  const json report = reported(ranged);
  BOOST_TEST(near(report["design"]["tolerance"], 0.125 / 0.325, 1e-8));
  BOOST_TEST(report["input"]["k"] == 0.55);
  BOOST_TEST((report["input"]["k_range"] == json{0.45, 0.55}));
  BOOST_TEST(report["input"]["lambda_range"].is_null());
  BOOST_TEST(near(report["cases"][0]["worst"]["peak_amplitude"], 2 * (0.55 - 0.1625), 1e-8));
  BOOST_TEST(motion_of(report)["p"] == 1);
  BOOST_TEST(!has_finding(report, "ranges_estimated"));
  Arguments of_lengths = ranged;
  of_lengths[6] = "0.9:1";
  BOOST_TEST(has_finding(reported(of_lengths), "ranges_estimated"));
}

// f + delta/w <= 0.08 g for w up to 441 mm, and the mass moves by 34 mm.
// It stops after 2.7172 s of a pulse of 3.5 s: W = 0.08 sin(2 pi t/3.5) is then -0.0789 g, and
// falls to 0 from there.
BOOST_AUTO_TEST_CASE(a_damper_that_locks_during_its_pulse_is_reported) {
  const json report =
      run({"design", STILLPOINT_DATA_DIR "/scenes/near_fault_pulse.json", "--json"}).json();
  BOOST_TEST(near(finding(report, "no_notch_works")["least_width_m"], 0.44088, 1e-4));
  BOOST_TEST(near(finding(report, "locks")["largest_load_while_locked"], 0.07891, 1e-4));
  BOOST_TEST(!has_finding(reported(asked), "locks"));
}

/// A pulse between the ends may leave it farther out than the strongest; the weakest may not move
/// it.
BOOST_AUTO_TEST_CASE(the_notch_that_will_be_built_is_tried_with_every_pulse_of_the_ranges) {
  const Arguments design(
      "design --pulse half-sine --k 0.4g:0.6g --pulse-duration 0.1:0.12 --period 2.6:2.8 "
      "--max-displacement 0.5 --delta-max-m 10mm");
  const json report = reported(design + "--notch-width-m 60mm");
  const json& built = report["built_notch"];
  const json& farthest = built["farthest_rest"];
  const double rest = farthest["response"]["stop_position"];
  BOOST_TEST(farthest["v0"].is_null());
  BOOST_TEST(std::abs(rest) >
             1.1 * std::abs(built["motion"]["response"]["stop_position"].get<double>()));
  Arguments simulate("simulate --excitation half-sine");
  for (const char* const field : {"k", "lambda", "p"}) {
    simulate = simulate + Arguments{std::string("--") + field, in_full(farthest[field])};
  }
  for (const char* const field : {"f", "delta"}) {
    simulate = simulate + Arguments{std::string("--") + field, in_full(report["design"][field])};
  }
  const json motion =
      reported(simulate + Arguments{"--notch-width", in_full(report["design"]["notch_width"])});
  BOOST_TEST(motion["response"]["stop_position"] == rest);

  const Arguments holds = design + "--hold 0.4";
  const json held = finding(reported(holds), "notch_fails");
  BOOST_TEST(held["what"] == "held");
  BOOST_TEST(near(held["k"], 0.4, 1e-12));
  BOOST_TEST(finding(reported(design + "--hold 0.3"), "notch_fails")["what"] != "held");
}

// In metres and seconds as without them, and every way to say how long the pulse is.
BOOST_AUTO_TEST_CASE(a_length_of_a_pulse_may_be_given_as_any_range) {
  const Arguments physical(
      "design --pulse half-sine --k 0.45g:0.55g --period 1.9:2.1 --max-displacement 600mm");
  const json by_duration = reported(physical + "--pulse-duration 0.5s:0.625s");
  const json by_hertz = reported(physical + "--excitation-frequency 0.8:1");
  const json by_lambda = reported(
      physical + Arguments{"--lambda", in_full(by_hertz["input"]["lambda_range"][0]) + ":" +
                                           in_full(by_hertz["input"]["lambda_range"][1])});
  const json& f = by_hertz["design"]["f"];
  BOOST_TEST(near(by_duration["design"]["f"], f.get<double>(), 1e-9));
  BOOST_TEST(near(by_lambda["design"]["f"], f.get<double>(), 1e-9));
  // A half-sine of 0.8 Hz lasts 0.625 s, and the longest period is that of the time unit.
  BOOST_TEST(near(by_hertz["input"]["lambda"], 0.8 * 2.1, 1e-12));
  BOOST_TEST(near(by_hertz["input"]["lambda_range"][1], 1.0 * 2.1, 1e-12));
  BOOST_TEST(near(by_hertz["input"]["p_range"][1], 2.1 / 1.9, 1e-12));
}

// `design` says the same of the region, whether it finds a damper or not.
BOOST_AUTO_TEST_CASE(region_matches_the_design) {
  write("parts.csv", "name,f,delta\nweak,0.05,0.4\ngood,0.2,0.4\nstrong,0.3,0.4\n");
  const Arguments near_fault{STILLPOINT_DATA_DIR "/scenes/near_fault_pulse.json"};
  for (const Arguments& task :
       {Arguments(region.begin() + 1, region.end()), near_fault,
        near_fault + "--acceleration-max 0.06", near_fault + "--k 0.07:0.09 --tolerance-f 0.9:1.1",
        Arguments(region.begin() + 1, region.end()) + "--tolerance 0.5"}) {
    const ProgramRun bounds = run("region --json" + task + "--catalogue parts.csv");
    const ProgramRun design = run("design --json" + task);
    BOOST_TEST(bounds.exit_code == design.exit_code);
    BOOST_TEST(bounds.json()["region"] == design.json()["region"]);
    for (const char* field : {"pulse", "k", "k_range", "lambda", "lambda_range", "p", "beta"}) {
      BOOST_TEST(bounds.json()["input"][field] == design.json()["input"][field], field);
    }
    const ProgramRun chosen = run("design --json" + task + "--catalogue parts.csv");
    BOOST_TEST(bounds.json()["catalogue"] == chosen.json()["catalogue"]);
  }
}

/// It returns for k >= 2 f, and reaches 2 (k - f).
BOOST_AUTO_TEST_CASE(a_point_says_which_pulses_and_springs_it_works_for) {
  const Arguments point = region + "--f 0.175 --delta 0.49 --criterion exact";
  const json report = reported(point);
  const json& served = report["works_for"];
  BOOST_TEST(served["v0"].is_null());
  BOOST_TEST(near(served["k"][0], 0.35, 1e-12));
  BOOST_TEST(near(served["k"][1], 0.575, 1e-12));
  BOOST_TEST((served["p"][0] < 1.0 && served["p"][1] > 1.0));
  const json& hits = report["hits"];
  const std::array ends{"held", "off_centre", "centred", "too_far"};
  const std::array to{0.175, 0.35, 0.575, 1.0};
  BOOST_TEST_REQUIRE(hits.size() == ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    BOOST_TEST(hits[i]["ends"] == ends.at(i));
    BOOST_TEST(near(hits[i]["to"], to.at(i), 1e-12));
  }
  check_null(reported(region + "--f 0.05 --delta 0.49"), {"works_for"});
  const json physical = reported(
      "region --pulse half-sine --k 0.5g --pulse-duration 0.1s --period 2s"
      " --max-displacement 0.3 --f 0.02 --delta-m 0.02")["physical"];
  BOOST_TEST(physical["works_for_velocity_m_per_s"].is_null());
  BOOST_TEST((physical["works_for_period_s"][0] < 2 && physical["works_for_period_s"][1] > 2));
}

/// In resonance, without friction, x = k/2 (tau cos tau - sin tau): the first swing turns at pi
/// k/2, the next at pi k.
BOOST_AUTO_TEST_CASE(a_limit_that_later_swings_exceed_is_not_simply_met) {
  const Arguments task("--pulse full-sine --k 0.1 --lambda 1 --p 1 --acceleration-max 0.2 --beta");
  const auto later = [&](const char* beta) {
    std::vector<std::string> figures;
    const json report = reported(Arguments("region --f 0 --delta 0") + task + beta);
    for (const json& now : report["findings"]) {
      if (now["kind"] == "exceeds_later") {
        BOOST_TEST(near(now["value"], 0.1 * M_PI, 1e-9));
        figures.push_back(now["figure"]);
      }
    }
    return figures;
  };
  BOOST_TEST((later("0.2") == std::vector<std::string>{"peak", "acceleration"}));
  BOOST_TEST((later("0.32") == std::vector<std::string>{"acceleration"}));
}

BOOST_AUTO_TEST_CASE(says_what_makes_the_reduction_poor) {
  const Arguments bad(
      "design --pulse rectangle --k 0.5 --lambda 3 --p 1 --beta 0.6 --objective amplitude");
  const json report = reported(bad);
  BOOST_TEST((report["pulse"]["warnings"] == json{"pulse_not_short", "friction_not_small"}));
  BOOST_TEST(motion_of(report)["response"]["stops_at_zero"] == true);
}

BOOST_AUTO_TEST_CASE(without_a_design_the_mends_are_in_terms_of_the_pulse) {
  Arguments tight = without(asked, "--beta");
  tight = tight + "--beta 0.02";
  const ProgramRun run = this->ending(3, tight + "--json");
  const json report = run.json();
  BOOST_TEST(report["design"].is_null());
  BOOST_TEST(report["pulse"].is_null());
  std::vector<std::string> inputs;
  for (const json& mend : report["mends"]) {
    inputs.push_back(mend["input"]);
  }
  BOOST_TEST((inputs == std::vector<std::string>{"k", "lambda", "p", "beta"}));
}

// Held while the load is at most f + delta/w = 0.0778 g; the paper's notch locks it later.
BOOST_AUTO_TEST_CASE(the_warning_of_a_lock_is_about_the_notch_that_will_be_built) {
  const Arguments design{"design", STILLPOINT_DATA_DIR "/scenes/near_fault_pulse.json"};
  const json held = finding(reported(design + "--notch-width-m 5mm"), "locks");
  BOOST_TEST(held["locked_from"] == 0);
  BOOST_TEST(near(held["largest_load_while_locked"], 0.08, 1e-12));
  // This one lets it move, and holds it in the end.
  BOOST_TEST(finding(reported(design + "--notch-width-m 500mm"), "locks")["locked_from"] > 0);
}

/// For a pulse given in seconds the suggested change is in seconds, as it can be given.
BOOST_AUTO_TEST_CASE(a_duration_as_printed_makes_it_feasible) {
  const auto lasting = [](const std::string& duration) {
    return Arguments{"design", "--pulse-duration", duration} +
           "--pulse half-sine --k 0.5g --period 2.8s --max-displacement 20mm";
  };
  const ProgramRun text = ending(3, lasting("70ms"));
  const std::regex figure("pulse duration +at most ([.0-9]+) s\n");
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(text.out, found, figure), text.out);
  succeed(lasting(found[1].str() + "s"));
  constexpr double beyond = 1 + 1e-4;  // five digits are printed
  BOOST_TEST(run(lasting(in_full(beyond * std::stod(found[1])) + "s")).exit_code == 3);
}

// With metres and seconds H = g / omega^2, so that p = 1 and lambda is a ratio of frequencies.
BOOST_AUTO_TEST_CASE(physical_input_goes_with_a_pulse) {
  const json report = reported(
      "design --pulse half-sine --k 0.5 --lambda 20 --period 2 "
      "--max-displacement 0.05 --mass 1000");
  BOOST_TEST(near(report["input"]["p"], 1, 1e-15));
  const double h = 9.80665 / (M_PI * M_PI);  // omega = pi
  BOOST_TEST(near(report["physical"]["length_unit_m"], h, 1e-15));
  BOOST_TEST(near(report["input"]["beta"], 0.05 / h, 1e-15));
  BOOST_TEST(near(report["physical"]["velocity_m_per_s"],
                  report["input"]["v0"].get<double>() * h * M_PI, 1e-14));
  BOOST_TEST(report["physical"]["delta2_m"].is_null());
  BOOST_TEST(near(report["physical"]["excitation_rad_per_s"], 20 * M_PI, 1e-14));
  BOOST_TEST(near(report["physical"]["excitation_duration_s"], 1.0 / 20, 1e-14));
}

namespace {

const std::vector<Wrong> wrong_pulses{
    {without(asked, "--pulse") + "--pulse harmonic",
     {"pulse = harmonic", "half-sine, full-sine or rectangle"}},
    {asked + "--arrivals 2", {"arrivals = 2", "with a pulse"}},
    {without(asked, "--k"), {"k is missing", "--k"}},
    {without(asked, "--lambda"), {"lambda is missing", "--lambda"}},
    {without(asked, "--k") + "--k 0", {"k = 0"}},
    {without(asked, "--k") + "--k 2:1", {"k = 2:1", "LOW <= HIGH"}},
    {without(asked, "--lambda") + "--lambda 2:1", {"lambda = 2:1", "LOW <= HIGH"}},
    {without(asked, "--lambda") + "--lambda 0.0099",
     {"lambda = 0.0099", "from 0.01 p to", "a longer pulse cannot be computed"}},
    {without(asked, "--lambda") + "--lambda 1e13",
     {"lambda = 1", "to 1e+12 p", "a shorter pulse cannot be computed"}},
    {asked + "--v0 1", {"v0 and pulse cannot be combined"}},
    {"design --pulse half-sine --k 0.5 --lambda 20 --period 2 --max-displacement 0.05 --velocity 1",
     {"pulse and velocity cannot be combined"}},
    {"design --v0 1 --p 1 --beta 0.9 --k 1", {"k needs a pulse", "--pulse"}},
    {region + "--residual 0.1", {"pulse and residual cannot be combined"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, wrong_pulse, data::make(wrong_pulses), wrong) {
  check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
