// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fmt/format.h>

#include <map>
#include <regex>

BOOST_FIXTURE_TEST_SUITE(region_command_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;

Arguments region(const Arguments& more = {}) {
  return "region --v0 1 --p 1 --beta 0.8" + more;
}

}  // namespace

/// An admissible point has all three blocks; another still has its hits.
BOOST_AUTO_TEST_CASE(a_point_says_which_hits_it_works_for) {
  const json good = reported(region("--f 0.3 --delta 0.4 --acceleration-max 1.1"));
  BOOST_TEST(near(good["works_for"]["v0"][0], std::sqrt(0.8), 1e-15));
  BOOST_TEST(near(good["works_for"]["p"][1], std::sqrt(1.1 * 1.1 - 0.3 * 0.3), 1e-15));
  BOOST_TEST(near(good["practice"]["notch_width_min"], 0.4320109600274175, 1e-14));
  BOOST_TEST(good["hits"][1]["ends"] == "centred");
  const json wrong = reported(region("--f 0.3 --delta 0.9"));
  check_null(wrong, {"works_for", "practice"});
  BOOST_TEST(wrong["hits"][0]["ends"] == "held");
  check_null(reported(region("--f 0.3")), {"hits"});
}

/// Up to V0^2 = 4 phi^2 + 4 phi sqrt(d + phi^2) + d, (36) of docs/theory.md, with the stiffest
/// spring, phi = f / 1.1.
BOOST_AUTO_TEST_CASE(hits_are_those_of_every_spring) {
  const json design = reported("design --v0 1 --p 0.9:1.1 --beta 2 --criterion exact");
  const double phi = design["design"]["f"].get<double>() / 1.1;
  const double d = 2 * design["design"]["delta"].get<double>();
  const double most = std::sqrt(4 * phi * phi + 4 * phi * std::sqrt(d + phi * phi) + d);
  bool found = false;
  for (const json& now : design["hits"]) {
    found = found || (now["ends"] == "centred" && near(now["to"], most, 1e-12));
  }
  BOOST_TEST(found, design["hits"].dump());
  const json physical =
      reported("design --velocity 0.4 --period 2.6:3 --max-displacement 0.3 --criterion exact");
  BOOST_TEST(physical["physical"]["hits"].size() == physical["hits"].size());
}

/// The strongest hit stops at its second arrival, which weaker ones do not reach.
BOOST_AUTO_TEST_CASE(what_is_not_admissible_violates_a_row) {
  const Arguments task("--v0 0:1 --p 1 --beta 2 --criterion exact --arrivals 2");
  const Arguments point = "region" + task + "--f 0.084 --delta 0.16";
  const json report = reported(point);
  BOOST_TEST(report["admissible"] == false);
  const json& row = report["constraints"][3];
  BOOST_TEST(row["name"] == "return");
  BOOST_TEST(row["satisfied"] == false);
  check_contains(one_line(run(point).out), {"rests off centre after the weaker hits of the range"});
  write("parts.csv", "name,f,delta\nA,0.084,0.16\n");
  const ProgramRun part = ending(3, "design" + task + "--catalogue parts.csv --json");
  BOOST_TEST(part.json()["catalogue"][0]["violates"][0]["name"] == "return");
}

/// No width that nobody gave is refused.
BOOST_AUTO_TEST_CASE(numbers_of_any_size_have_an_answer) {
  for (const char* const task :
       {"--v0 1e76 --p 1e-76 --beta 2e152", "--v0 1e140 --p 1e-140 --beta 2e280",
        "--v0 1e-140 --p 1e140 --beta 2e-280", "--v0 1e-140 --p 1e-20 --beta 1.2e-120"}) {
    succeed("design" + Arguments(task));
  }
}

/// Each bound names the variable that it bounds, in the report for people as in JSON.
BOOST_AUTO_TEST_CASE(limits_bound_the_variable_that_they_name) {
  const Arguments arguments = region("--f 0.3 --delta 0.4 --f-max 0.31 --delta-max 0.41");
  std::map<std::string, std::string> variable;
  const json report = reported(arguments);
  for (const json& now : report["constraints"]) {
    variable[now.at("name")] = now.value("variable", "none");
  }
  const std::map<std::string, std::string> expected{
      {"dead_zone", "f"}, {"start", "delta"}, {"amplitude", "f"},    {"return", "f"},
      {"stop", "delta"},  {"f_max", "f"},     {"delta_max", "delta"}};
  BOOST_TEST(variable == expected);
  const std::string text = run(arguments + "--verbose").out;
  for (const auto& [name, value] :
       std::map<std::string, std::string>{{"dead zone", "f <"},
                                          {"start", "delta <="},
                                          {"amplitude", "f >="},
                                          {"return", "f <="},
                                          {"stop", "delta >"},
                                          {"largest f", "f <="},
                                          {"largest delta", "delta <="}}) {
    BOOST_TEST(std::regex_search(text, std::regex(fmt::format("\n +{} +{} ", name, value))), text);
  }
}

/// Where amplitude does not bind, f may come as near to 0 as it likes: its edge is 0, not what is
/// left of v0^2 divided by v0 twice.
BOOST_AUTO_TEST_CASE(edge_at_zero_is_zero) {
  // V0 = beta p in decimals, which as doubles differ in their last bits.
  for (const auto& [v0, p, beta] : {std::array{"1.1", "0.1", "11"}, std::array{"0.3", "0.1", "3"},
                                    std::array{"0.6", "0.2", "3"}, std::array{"0.7", "0.1", "7"}}) {
    const json report = reported({"region", "--v0", v0, "--p", p, "--beta", beta});
    BOOST_TEST(report["region"]["f2"].get<double>() == 0, "v0 = " << v0);
    BOOST_TEST(report["region"]["f_lower"].get<double>() == 0, "v0 = " << v0);
  }
}

BOOST_AUTO_TEST_CASE(huge_friction_is_refused_or_reported_in_finite_numbers) {
  for (const char* f : {"1e150", "1e300"}) {
    const Arguments arguments = region({"--f", f, "--delta", "1"});
    const ProgramRun text = run(arguments);
    check_only_finite(text.out);
    if (text.exit_code == 2) {
      BOOST_TEST(contains(text.err, "f = "), text.err);
      continue;
    }
    check_null(reported(arguments), {"delta1_exact"});
  }
}

BOOST_AUTO_TEST_CASE(works_in_metres_and_seconds) {
  const Arguments isolator("region --velocity 0.4 --period 3 --max-displacement 0.16 --mass 2e5");
  const json report = reported(isolator + "--f 0.0225 --delta-m 0.006");
  BOOST_TEST(report["admissible"] == true);
  const json& quantities = report["physical"];
  check_near(quantities,
             {{"delta2_m", 0.16 / (2 * 9.80665)},
              {"friction_force_n", 2e5 * 9.80665 * 0.0225},
              {"energy_per_passage_j", 2e5 * 9.80665 * 0.006}},
             1e-14);
  BOOST_TEST(near(quantities["delta_m"], 0.006, 1e-15));
  const double length = quantities["length_unit_m"];
  check_near(quantities,
             {{"delta1_exact_m", report["delta1_exact"].get<double>() * length},
              {"delta1_published_m", report["delta1_published"].get<double>() * length}},
             1e-15);
  // The dimensionless figures again.
  const json& input = report["input"];
  const Arguments again{"region",
                        "--v0",
                        in_full(input["v0"]),
                        "--p",
                        in_full(input["p"]),
                        "--beta",
                        in_full(input["beta"])};
  BOOST_TEST(reported(again)["region"] == report["region"]);
}

/// A suggested change is in the terms given: for a stiffness it is a stiffness.
BOOST_AUTO_TEST_CASE(mends_name_the_stiffness_if_it_was_given) {
  const auto isolator = [](const std::string& stiffness) {
    return Arguments{"region", "--velocity", "0.4", "--stiffness", stiffness, "--max-displacement",
                     "0.1",    "--mass",     "1e5"};
  };
  const ProgramRun text = ending(3, isolator("6e5"));
  BOOST_TEST(contains(text.out, "  stiffness         at least "), text.out);
  BOOST_TEST(!contains(text.out, "  period            at"), text.out);
  // beta p / V0 = X omega / v = 1/sqrt 2, (10), so that k = m v^2 / (2 X^2).
  const json quantities = run(isolator("6e5") + "--json").json()["physical"];
  const double mended = quantities["stiffness_mend_n_per_m"];
  constexpr double digits = 1e-13;  // to the safe side
  BOOST_TEST(near(mended, 1e5 * 0.16 / 0.02, digits));
  succeed(isolator(in_full(mended)));
  BOOST_TEST(run(isolator(in_full(mended * (1 - 1e-12)))).exit_code == 3);

  const Arguments by_period("region --velocity 0.4 --period 2.5651 --max-displacement 0.1");
  const json without_mass = run(by_period + "--json").json()["physical"];
  check_null(without_mass, {"stiffness_mend_n_per_m"});
  BOOST_TEST(contains(run(by_period).out, "  period            at most "));
}

/// f >= 0.0051 p^2 rests off centre by more than 10 mm after some weaker hit of the range.
BOOST_AUTO_TEST_CASE(a_damper_that_only_weaker_hits_spoil_is_told_so) {
  const json report = reported(
      "region --velocity 0:0.4 --period 2.8 --max-displacement 0.2 "
      "--arrivals 3 --residual-m 0.01 --f 0.006 --delta-m 0.002");
  check_contains(report["verdict"].get<std::string>(),
                 {"The damper is not admissible: it rests too far off after the weaker hits"});
  BOOST_TEST(near(finding(report, "catches_weak_hits")["least_velocity_m_per_s"],
                  std::sqrt(2 * 0.002 * 9.80665), 1e-12));
}

/// f = 5 turns V0 = 1 within 0.0991, but the dead zone is wider than beta from f = 0.6 on.
BOOST_AUTO_TEST_CASE(friction_that_could_hold_the_mass_at_the_limit_is_all_that_is_wrong) {
  const Arguments arguments =
      "region --v0 1 --p 1 --beta 0.6 --residual 0.1 --f 5 --delta 0.1 --criterion exact";
  const json report = ending(3, arguments + "--json").json();
  BOOST_TEST(report["admissible"] == false);
  for (const json& now : report["constraints"]) {
    BOOST_TEST(now["satisfied"] == (now["name"] != "dead_zone"), now);
  }
  const std::string text = run(arguments).out;
  check_contains(one_line(text),
                 {"The damper is not admissible: it could be held at 0.6 by friction: "});
}

/// Delta1(f2) = (2 f2 - S)^2/2 with f2 = 0.225, the largest of all feasible f, rounded up.
BOOST_AUTO_TEST_CASE(says_which_delta_goes_with_every_feasible_f) {
  const double radius = std::hypot(1, 0.225);
  const double least = (radius - 0.45) * (radius - 0.45) / 2;
  const std::string text = one_line(run("region --v0 1 --p 1 --beta 0.8").out);
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(
      text, found, std::regex("With any of them, delta of ([0-9.]+) to 0.5 is admissible")));
  BOOST_TEST(std::stod(found[1]) >= least);
  BOOST_TEST(near(std::stod(found[1]), least, 1e-5));
}

/// beta = 0.70710679 leaves f from (1/beta - beta)/2 = 0.3535533774 to 1/sqrt(8) = 0.3535533906,
/// less than six digits tell apart.
BOOST_AUTO_TEST_CASE(bounds_of_a_narrow_region_can_both_be_met) {
  const std::string text = run("region --v0 1 --p 1 --beta 0.70710679").out;
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(
      text, found, std::regex("amplitude +f >= ([0-9.]+)\n +return +f <= ([0-9.]+)\n")));
  BOOST_TEST(std::stod(found[1]) <= std::stod(found[2]));
}

BOOST_AUTO_TEST_CASE(text_shows_bounds_and_judgement) {
  const ProgramRun text = succeed(region("--f 0.36 --delta 0.4"));
  check_contains(text.out, {"Admissible region", "0.225", "0.353553", "0.7071068", "not admissible",
                            "violated", "does not return"});
  // f3 = 1/sqrt(8) and Delta1(0.26) = (sqrt(1.0676) - 0.52)^2/2 = 0.1317114, rounded inwards.
  check_contains(succeed(region("--f 0.26 --delta 0.37 --verbose")).out,
                 {"f <= 0.353553 ", "delta > 0.131712 "});
}

/// Between the two Delta1 the mass stops: only the published criterion is violated.
BOOST_AUTO_TEST_CASE(between_both_delta1_the_words_are_those_of_the_criterion) {
  const Arguments beside("region --v0 1 --p 1 --beta 0.9 --f 0.2 --delta");
  check_contains(one_line(succeed(beside + "0.18").out), {": it stops at x = 0, but not by "});
  check_contains(one_line(succeed(beside + "0.17").out), {": it passes x = 0: delta must be "});
}

BOOST_AUTO_TEST_CASE(a_friction_alone_has_no_notch) {
  const Arguments isolator(
      "region --velocity 0.4 --period 2.8 --mass 1200t --max-displacement 0.15");
  const std::string alone = run(isolator + "--f 0.024").out;
  BOOST_TEST(contains(alone, "a friction force of 282.43 kN"), alone);
  BOOST_TEST(!contains(alone, "takes"), alone);
  BOOST_TEST(contains(run(isolator + "--f 0.024 --delta-m 6mm").out, "70.608 kJ"));
}

/// Delta1 is that of the first arrival.
BOOST_AUTO_TEST_CASE(delta1_is_shown_only_where_the_first_arrival_decides) {
  const auto shown = [&](const Arguments& command) {
    const std::string text = run(command).out;
    return contains(text, "Delta1(f)") || contains(text, "  delta needed  ");
  };
  const Arguments first("--f 0.3 --delta 0.4");
  const Arguments second("--f 0.071 --delta 0.235");
  const Arguments later("--beta 0.95 --arrivals 3");
  const Arguments task("--v0 1 --p 1");
  const Arguments judged = "region" + task + later;
  BOOST_TEST(run(judged + "--f 0.071 --delta 0.235 --json").json()["admissible"] == true);
  BOOST_TEST(!shown(judged + second));
  BOOST_TEST(shown(judged + first));
  BOOST_TEST(shown(region(first)));
  BOOST_TEST(shown(judged + "--f 0.071"));
  const Arguments designed = "design --f-max 0.15 --verbose" + task;
  BOOST_TEST(!shown(designed + later));
  BOOST_TEST(shown(designed + "--beta 0.95"));
}

/// "peak ...", "rest ..." and "acceleration ..." of the answer.
BOOST_AUTO_TEST_CASE(a_point_is_told_like_the_design_that_it_is) {
  const auto told = [this](const Arguments& arguments) {
    const std::string text = run(arguments).out;
    const std::size_t begin = text.find("\n  peak  ");
    BOOST_TEST_REQUIRE(begin != std::string::npos, text);
    const std::size_t acceleration = text.find("\n  acceleration  ", begin);
    return text.substr(begin, text.find("\n  ", text.find(" g", acceleration)) - begin);
  };
  for (const char* const scene : {"isolator", "varying_hits", "later_arrival", "residual"}) {
    const std::string file = STILLPOINT_DATA_DIR "/scenes/" + std::string(scene) + ".json";
    const json report = reported({"design", file});
    const json& found = report["design"];
    const Arguments where =
        report["physical"].is_null()
            ? Arguments{"--f", in_full(found["f"]), "--delta", in_full(found["delta"])}
            : Arguments{"--f", in_full(found["f"]), "--delta-m",
                        in_full(report["physical"]["delta_m"])};
    BOOST_TEST(told(Arguments{"region", file} + where) == told({"design", file}), scene);
  }
  // A damper that is not admissible moves all the same: sqrt(0.01 + 1) - 0.1 = 0.905 of 0.8.
  BOOST_TEST(contains(told(region("--f 0.1 --delta 0.4")), "0.904988, 113.1 % of the 0.8 allowed"));
}

/// What the mass feels where it crosses a whole notch, followed by simulate with its edges.
BOOST_AUTO_TEST_CASE(the_bound_of_the_notch_is_what_a_passage_feels) {
  const Arguments damper("--velocity 0.4 --period 2.8 --f 0.01 --delta-m 3mm");
  const std::string text =
      std::regex_replace(run(Arguments("region --max-displacement 0.2 --arrivals 2") + damper).out,
                         std::regex("\\s+"), " ");
  std::smatch found;
  BOOST_TEST_REQUIRE(
      std::regex_search(text, found, std::regex("at most ([0-9.]+) g inside one 20 mm wide")),
      text);
  const double stated = std::stod(found[1]);
  const double felt = reported(Arguments("simulate --notch-width-m 20mm") +
                               damper)["response"]["peak_absolute_acceleration"];
  BOOST_TEST(felt <= stated);
  BOOST_TEST(felt > stated - 0.001);
}

/// As `design` says it.
BOOST_AUTO_TEST_CASE(an_admissible_point_under_a_pulse_says_when_its_notch_acts) {
  const Arguments strong(
      "region --pulse full-sine --k 0.08g --pulse-duration 3.5s --period 2.8s --max-displacement "
      "150mm --delta-max-m 10mm --f 0.062 --delta-m 8mm");
  check_contains(one_line(run(strong).out),
                 {"No notch works: only one wider than 444.45 mm would let the load move the "
                  "mass, but the peak is 34.255 mm.",
                  "; 0.08 g if the notch holds the mass"});
  const Arguments weak(
      "region --pulse half-sine --k 4g --pulse-duration 9ms --period 2.8s --max-displacement 97mm "
      "--delta-max-m 1mm --f 0.0125 --delta-m 1mm");
  check_contains(one_line(run(weak).out),
                 {" This is for a notch that acts only after the start; --notch-width-m shows "
                  "what a real one does. "});
}

/// The strongest hit with the stiffest spring has the largest base shear 0.1087, of which the
/// spring's share is 0.08467: A = 0.08467 g (2.66 s/(2 pi))^2 = 148.8 mm, and m g 0.1087/A.
BOOST_AUTO_TEST_CASE(the_secant_stiffness_of_ranges_says_of_which_end_it_is) {
  const std::string file = STILLPOINT_DATA_DIR "/scenes/varying_hits.json";
  const json report = reported({"region", file, "--f", "0.024", "--delta-m", "4mm"});
  const double spring = report["input"]["p"].get<double>() * report["input"]["p"].get<double>();
  const double stiffest = std::pow(2.94 / 2.66, 2);
  BOOST_TEST(report["practice_worst"]["secant_stiffness"].get<double>() / spring ==
                 stiffest * 0.1087 / 0.08467,
             tt::tolerance(1e-3));
}

/// With the strongest hit on the softest spring, and at the worst end: S = sqrt(f^2 + (V0 p)^2).
BOOST_AUTO_TEST_CASE(practice_is_that_of_the_motion_shown_and_practice_worst_that_of_the_ranges) {
  const Arguments point("--beta 2 --f 0.3 --delta 0.3");
  const json ranged = reported("region --v0 0.9:1.1 --p 0.95:1.05 --criterion exact" + point);
  const auto shear = [&ranged](const char* of) {
    return ranged[of]["base_shear_over_weight"].get<double>();
  };
  constexpr double rounding = 1e-15;
  BOOST_TEST(near(shear("practice"), std::hypot(0.3, 1.1 * 0.95), rounding));
  BOOST_TEST(near(shear("practice_worst"), std::hypot(0.3, 1.1 * 1.05), rounding));
  const json one = reported("region --v0 1 --p 1" + point);
  BOOST_TEST(one["practice"].is_object());
  check_null(one, {"practice_worst"});
}

BOOST_AUTO_TEST_CASE(feasible_f_leaves_out_the_gap_between_strips) {
  const Arguments task{"region", STILLPOINT_DATA_DIR "/scenes/residual.json", "--tolerance", "0.2"};
  const std::string text = std::regex_replace(run(task).out, std::regex("\\s+"), " ");
  std::smatch found;
  BOOST_TEST_REQUIRE(
      std::regex_search(text, found,
                        std::regex("Feasible f with the tolerance asked for: up to ([0-9.]+) or "
                                   "([0-9.]+) to ([0-9.]+)\\.")),
      text);
  const auto verdict = [&](double f) { return run(task + Arguments{"--f", in_full(f)}).out; };
  const double low = std::stod(found[1]);
  const double high = std::stod(found[2]);
  BOOST_TEST(contains(verdict((low + high) / 2), "no delta keeps the tolerance asked for"));
  for (const double f : {low * 0.999, high * 1.001}) {
    BOOST_TEST(!contains(verdict(f), "no delta"), f);
  }
}

/// The mass stops at its second arrival, and at its first: the criterion alone asks for more.
BOOST_AUTO_TEST_CASE(a_later_arrival_may_miss_the_published_criterion_alone) {
  for (const auto& [damper, arrival] : {std::pair{"--v0 1.054 --p 1 --f 0.12 --delta 0.1", 2},
                                        std::pair{"--v0 1 --p 1 --f 0.34 --delta 0.02", 1}}) {
    const json motion = reported(Arguments("simulate") + damper)["response"];
    BOOST_TEST(motion["outcome"] == "stopped_at_zero");
    BOOST_TEST(motion["zero_passages"] == arrival - 1);
    const Arguments task = Arguments("region --beta 1 --arrivals 40") + damper;
    check_contains(one_line(run(task).out),
                   {": it stops at x = 0, but not by the published criterion: "});
    const json point = reported(task);
    BOOST_TEST(point["constraints"][3]["satisfied"] == true);
    BOOST_TEST(point["constraints"][4]["satisfied"] == false);
  }
}

/// With a residual a rest counts only after so many arrivals.
BOOST_AUTO_TEST_CASE(a_rest_within_the_residual_after_the_last_arrival_says_so) {
  check_contains(
      one_line(run("region --v0 1 --p 1 --beta 1 --residual 0.6 --f 0.3 --delta 0.02").out),
      {": it passes x = 0, and only the first arrival counts (--arrivals): ",
       " none needed, rest within the residual up to "});
}

/// The limit of v0 does not depend on v0.
BOOST_AUTO_TEST_CASE(what_is_too_small_must_grow_by_so_much_which_is_enough) {
  const auto at = [](double v0) {
    return Arguments("region --p 1 --beta 2 --arrivals 12 --f 0.06 --delta 0.01") +
           Arguments{"--v0", in_full(v0)};
  };
  const std::string text = one_line(run(at(1)).out);
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(text, found, std::regex("v0 must be ([.0-9]+) % larger\\.")),
                     text);
  const double percent = std::stod(found[1]);
  const auto returns = [&](double more) {
    return reported(at(1 + more / 100))["constraints"][3]["satisfied"] == true;
  };
  BOOST_TEST(returns(percent));
  BOOST_TEST(!returns(percent - 0.1));  // the last of two digits
}

BOOST_AUTO_TEST_CASE(a_limit_of_the_acceleration_is_one_outside_the_notch) {
  const std::string near_fault =
      one_line(run({"region", STILLPOINT_DATA_DIR "/scenes/near_fault_pulse.json"}).out);
  check_contains(near_fault, {" acceleration outside the notch <= 0.12 g "});
}

/// Its box is narrower than four digits of f.
BOOST_AUTO_TEST_CASE(a_figure_tells_f_within_its_own_box) {
  succeed("region --v0 1 --p 1 --beta 0.9 --f 0.35355 --delta 0.3 --html page.html");
  check_contains(read("page.html"), {"how far f\u00a0=\u00a00.35355\u00a0and"});
  succeed("design --v0 1 --p 1 --beta 1 --tolerance-delta 0.2 --html page.html");
  check_contains(read("page.html"), {"may be off, with f exactly as given"});
}

BOOST_AUTO_TEST_SUITE_END()
