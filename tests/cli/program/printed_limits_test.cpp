// SPDX-License-Identifier: MIT
// What a report prints as a limit can be given as it stands: the printed ends of a range lie in it,
// and an input set to a printed mend has a design.
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(printed_limits_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
constexpr unsigned seed = 20264;

const std::string number = R"(([0-9](?:[0-9.e+-]*[0-9])?))";

/// The numbers of what the text says there: "0.5 to 0.7", "at least 0.5", "exactly 0.5".
std::vector<std::string> ends_of(const std::string& text, const std::string& before) {
  std::smatch found;
  const std::regex range(before + "(?:at least |exactly |up to )?" + number + "(?: to " + number +
                         ")?");
  BOOST_TEST_REQUIRE(std::regex_search(text, found, range), before << " in " << text);
  std::vector<std::string> ends{found[1]};
  if (found[2].matched) {
    ends.push_back(found[2]);
  }
  return ends;
}

double uniform(std::mt19937& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

/// A hit, a spring and a stroke with some room for a design, or none.
std::array<std::string, 3> random_task(std::mt19937& random, double least, double most) {
  const double v0 = std::pow(10, uniform(random, -0.5, 0.5));
  const double p = std::pow(10, uniform(random, -0.5, 0.5));
  return {in_full(v0), in_full(p), in_full(v0 / p * uniform(random, least, most))};
}

BOOST_AUTO_TEST_CASE(ends_of_what_a_damper_serves_are_served) {
  std::mt19937 random(seed);
  for (int i = 0; i < 15; ++i) {
    const auto drawn = random_task(random, 0.75, 1.2);
    const auto& [v0, p, beta] = drawn;
    const Arguments task{"--v0", v0, "--p", p, "--beta", beta};
    const json design =
        reported(Arguments{"design", "--objective", i % 2 == 0 ? "robust" : "amplitude"} + task +
                 Arguments{"--tolerance", i % 2 == 0 ? "0" : "0.01"})["design"];
    const Arguments damper{"--f", in_full(design["f"]), "--delta", in_full(design["delta"])};
    const std::string text = succeed(Arguments{"region"} + task + damper).out;
    const auto admissible = [&](const std::string& speed, const std::string& spring) {
      return reported(Arguments{"region", "--v0", speed, "--p", spring, "--beta", drawn[2]} +
                      damper)["admissible"] == true;
    };
    for (const std::string& end : ends_of(text, "works for +v0 of ")) {
      BOOST_TEST(admissible(end, p), end << " in " << text);
    }
    for (const std::string& end : ends_of(text, "\n +p of ")) {
      BOOST_TEST(admissible(v0, end), end << " in " << text);
    }
  }
}

BOOST_AUTO_TEST_CASE(ends_of_the_feasible_f_are_feasible) {
  std::mt19937 random(seed);
  for (int i = 0; i < 15; ++i) {
    const auto [v0, p, beta] = random_task(random, 0.7072, 0.9);
    const Arguments task{"region", "--v0", v0, "--p", p, "--beta", beta};
    const std::string delta2 = in_full(reported(task)["region"]["delta2"]);
    const std::string text = succeed(task).out;
    for (const std::string& f : ends_of(one_line(text), "Feasible f: ")) {
      BOOST_TEST(reported(task + Arguments{"--f", f, "--delta", delta2})["admissible"] == true,
                 f << " in " << text);
    }
  }
}

/// The best acceleration and the best peak are at the ends of the feasible f.
BOOST_AUTO_TEST_CASE(a_design_on_an_edge_prints_a_feasible_f) {
  std::mt19937 random(seed);
  for (int i = 0; i < 8; ++i) {
    const auto [v0, p, beta] = random_task(random, 0.72, 0.9);
    const Arguments task{
        "design", "--objective", i % 2 == 0 ? "amplitude" : "acceleration", "--v0", v0, "--p", p,
        "--beta", beta};
    const std::string text = run(task).out;
    const double f = std::stod(ends_of(text, "damper +f = ").front());
    const json region = reported(task)["region"];
    BOOST_TEST(f >= region["f_lower"].get<double>(), text);
    BOOST_TEST(f <= region["f_upper"].get<double>(), text);
  }
}

BOOST_AUTO_TEST_CASE(mends_as_printed_mend) {
  std::mt19937 random(seed);
  const std::regex mend(
      "\n +(velocity|period|max displacement|v0|p|beta|largest f|largest delta|"
      "largest acceleration) +at (?:least|most) " +
      number + "( m/s| s| mm|)");
  int tried = 0;
  for (int i = 0; i < 30; ++i) {
    const auto [v0, p, beta] = random_task(random, 0.4, 1.1);
    const bool physical = i % 3 == 0;
    Arguments task = physical ? Arguments{"design",
                                          "--velocity",
                                          v0,
                                          "--period",
                                          p,
                                          "--max-displacement",
                                          in_full(std::stod(v0) * std::stod(p) / 2 /
                                                  std::numbers::pi * uniform(random, 0.4, 0.7))}
                              : Arguments{"design", "--v0", v0, "--p", p, "--beta", beta};
    if (i % 3 == 1) {
      const double f3 = std::stod(v0) * std::stod(p) / std::sqrt(8);
      task =
          task + Arguments{"--f-max", in_full(f3 * uniform(random, 0.3, 1)), "--tolerance", "0.05"};
      task = task + Arguments{"--acceleration-max", in_full(f3 * uniform(random, 2.7, 3.2))};
    }
    const ProgramRun none = run(task);
    if (none.exit_code != 3) {
      continue;
    }
    for (std::sregex_iterator now(none.out.begin(), none.out.end(), mend), end; now != end; ++now) {
      Arguments mended = task;
      const std::string name = (*now)[1];
      std::string option = "--" + (name.starts_with("largest ") ? name.substr(8) + "-max" : name);
      std::ranges::replace(option, ' ', '-');
      *(std::ranges::find(mended, option) + 1) = (*now)[2].str() + ((*now)[3] == " mm" ? "mm" : "");
      BOOST_TEST(run(mended).exit_code == 0, option << " as in " << none.out);
      ++tried;
    }
  }
  BOOST_TEST(tried > 40);  // otherwise little would be tested
}

BOOST_AUTO_TEST_SUITE_END()
