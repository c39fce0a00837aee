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
}

/// f >= 0.0051 p^2 rests off centre by more than 10 mm after some weaker hit of the range.
BOOST_AUTO_TEST_CASE(a_damper_that_only_weaker_hits_spoil_is_told_so) {
  const json report = reported(
      "region --velocity 0:0.4 --period 2.8 --max-displacement 0.2 "
      "--arrivals 3 --residual-m 0.01 --f 0.006 --delta-m 0.002");
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

/// The mass stops at its second arrival, and at its first: the criterion alone asks for more.
BOOST_AUTO_TEST_CASE(a_later_arrival_may_miss_the_published_criterion_alone) {
  for (const auto& [damper, arrival] : {std::pair{"--v0 1.054 --p 1 --f 0.12 --delta 0.1", 2},
                                        std::pair{"--v0 1 --p 1 --f 0.34 --delta 0.02", 1}}) {
    const json motion = reported(Arguments("simulate") + damper)["response"];
    BOOST_TEST(motion["outcome"] == "stopped_at_zero");
    BOOST_TEST(motion["zero_passages"] == arrival - 1);
    const Arguments task = Arguments("region --beta 1 --arrivals 40") + damper;
    const json point = reported(task);
    BOOST_TEST(point["constraints"][3]["satisfied"] == true);
    BOOST_TEST(point["constraints"][4]["satisfied"] == false);
  }
}

BOOST_AUTO_TEST_SUITE_END()
