// SPDX-License-Identifier: MIT
// What a command reports beyond the lines of commands/reports.
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <stillpoint/answers/answers.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/report/report.hpp>

BOOST_FIXTURE_TEST_SUITE(commands_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using right::design;

BOOST_AUTO_TEST_CASE(a_catalogue_of_100_MB_is_refused_before_it_is_read_to_its_end) {
  {
    std::ofstream file(path("huge.csv"));
    file << "name,f,delta\n";
    for (int i = 0; i <= 100'000; ++i) {
      file << 'p' << i << ",0.2,0.4\n";
    }
  }
  fs::resize_file(path("huge.csv"), 100'000'000);
  check_refusal(run(design("--catalogue huge.csv")),
                {"catalogue huge.csv", "line 100002", "more than 100000 parts"});
  write("one_line.csv", "name,f,delta\n");
  fs::resize_file(path("one_line.csv"), 100'000'000);
  check_refusal(run(design("--catalogue one_line.csv")),
                {"catalogue one_line.csv", "line 2", "65536 bytes"});
}

BOOST_AUTO_TEST_CASE(a_catalogue_is_drawn_by_region_and_works_with_arrivals) {
  write("few.csv", "name,f,delta\nfirst,0.26,0.37\nsecond,0.05,0.2\nfar,9,9\n");
  const Arguments region("region --v0 1 --p 1 --beta 1.1 --catalogue few.csv --svg out --arrivals");
  BOOST_TEST(reported(region + "2")["catalogue"][1]["admissible"] == true);
  const std::string figure = read("out/region.svg");
  BOOST_TEST(contains(figure, "parts that fit"));
  BOOST_TEST(!contains(figure, "tolerate too little"));
  // The first withstands 35 %.
  BOOST_TEST(run(region + "1 --tolerance 0.4").exit_code == 3);
  const std::string strict = read("out/region.svg");
  BOOST_TEST(
      contains(strict, "data-name=\"parts that tolerate too little\" data-at=\"0.26 0.37\""));
  BOOST_TEST(!contains(strict, "parts that fit"));
}

BOOST_AUTO_TEST_CASE(a_report_is_the_same_json_in_a_file) {
  const ProgramRun text = succeed(design(0.9, "--output report.json"));
  BOOST_TEST(text.out.starts_with("Damper design"));
  const std::string written = read("report.json");
  BOOST_TEST(without_wall_times(json::parse(written)) == without_wall_times(reported(design(0.9))));
  BOOST_TEST(contents().size() == 1U);

  const ProgramRun both = run(design(0.9, "--json --output report.json"));
  BOOST_TEST(read("report.json") == both.out);
  BOOST_TEST(run(design(0.6, "--output report.json")).exit_code == 3);  // also without a damper
  BOOST_TEST(json::parse(read("report.json"))["region"]["feasible"] == false);
}

/// The report is still printed.
BOOST_AUTO_TEST_CASE(a_failed_cross_check_is_exit_code_4_with_a_report) {
  const stillpoint::design::Problem problem{1, 1, 0.8};
  auto result = stillpoint::design::design({problem});
  const auto& [f, delta, tolerance] = result.finding.value().point;
  auto wrong = stillpoint::design::predict(problem, f);
  wrong.peak_amplitude *= 1 + 1e-6;
  result.finding->cross_check = stillpoint::design::cross_check(wrong, problem, f, delta);
  const stillpoint::report::DesignReport failed{result};
  BOOST_TEST(stillpoint::answers::exit_code(failed) == 4);
  const auto check = stillpoint::report::json(failed)["cross_check"];
  BOOST_TEST(check["passed"] == false);
  BOOST_TEST(check["methods"][0]["passed"] == false);
}

// design --pulse and region --pulse, from the flags to the report.

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

BOOST_AUTO_TEST_CASE(counts_beyond_the_integers_of_a_double_are_numbers) {
  // At once: five seconds, also under sanitizers on a loaded machine. A count that a double holds
  // exactly is written as an integer.
  const Surroundings impatient{.patience = std::chrono::seconds(5)};
  const Arguments motion("simulate --v0 1 --p 1 --f 0 --json --delta");
  succeed(motion + "0", impatient);
  succeed(motion + "1e-20", impatient);
  const ProgramRun exact = succeed(motion + "4.9e-13", impatient);
  BOOST_TEST(contains(exact.out, "\"half_cycles\": 1020408163266,"));
}

BOOST_AUTO_TEST_CASE(figures_beyond_a_double_are_refused_or_left_out_but_never_infinite) {
  const Arguments enormous(
      "simulate --velocity 1 --period 1 --mass 1e30 --gravity 1e30 --f 1 --delta-m 1e260");
  check_only_finite(run(enormous).out);
  const ProgramRun answer = run(enormous + "--json");
  BOOST_TEST((answer.exit_code == 0 || answer.exit_code == 2));
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

double number(const json& report, const char* part, const char* field) {
  return report.at(part).at(field).get<double>();
}

// An isolator of 3 s and 200 t that sets off with 0.4 m/s and has 0.16 m, worked out by hand:
// omega = 2 pi / 3, H = 0.4 / omega, time sqrt(H/g), velocity sqrt(g H), k = m omega^2.
constexpr double mass = 2e5;
constexpr double gravity = 9.80665;
constexpr double omega = 2.0943951023931953;
constexpr double length = 0.19098593171027440;

const Arguments isolator("design --velocity 0.4 --max-displacement 0.16");

// After the turn at A the spring gives omega^2 A^2 and friction takes 2 g f A of the square of the
// speed; what is left is the arrival's.
BOOST_FIXTURE_TEST_CASE(values_of_practice_are_those_of_the_motion_in_units, Sandbox) {
  constexpr double digits = 1e-12;
  const json report = reported(isolator + "--period 3 --mass 2e5 --acceleration-max 0.2");
  const json& quantities = report["physical"];
  const double peak = quantities["peak_m"];
  const double force = quantities["friction_force_n"];
  const double square = omega * omega * peak * peak - 2 * force / mass * peak;
  check_near(quantities,
             {{"arrival_speed_m_per_s", std::sqrt(square)},
              {"jump_m_per_s", std::sqrt(square)},
              {"impulse_at_stop_n_s", mass * std::sqrt(square)},
              {"energy_at_stop_j", mass * square / 2},
              {"secant_stiffness_n_per_m", mass * omega * omega + force / peak},
              {"notch_width_min_m", number(report, "practice", "notch_width_min") * length}},
             digits);
  // The first passage takes the most from a damper that stops the mass at the second.
  const json second = reported(
      "region --velocity 0.4 --max-displacement 0.19 --period 3 --mass 2e5 --arrivals 2 "
      "--f 0.01 --delta-m 0.0035");
  BOOST_TEST(second["design"]["arrival"] == 2);
  const double impulse = second["physical"]["impulse_largest_n_s"];
  BOOST_TEST(near(impulse / mass / std::sqrt(gravity * length),
                  number(second, "practice", "impulse_largest"), digits));
  int rests = 0;
  for (std::size_t i = 0; i < second["hits"].size(); ++i) {
    const json& rest = second["hits"][i]["rest"];
    if (!rest.is_null()) {
      ++rests;
      BOOST_TEST(
          near(second["physical"]["hits"][i]["rest_m"], rest.get<double>() * length, digits));
    }
  }
  BOOST_TEST(rests > 0);
}

BOOST_AUTO_TEST_SUITE_END()
