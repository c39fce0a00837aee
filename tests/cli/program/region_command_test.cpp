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
