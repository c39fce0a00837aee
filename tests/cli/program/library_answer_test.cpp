// SPDX-License-Identifier: MIT
// What the program reports is what the library answers, to the last byte. The tests of core and
// design state why those numbers are right.
#include "cli_test.hpp"
#include "testing/simulation_of.hpp"

#include <stillpoint/answers/answers.hpp>
#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/report/report.hpp>

BOOST_AUTO_TEST_SUITE(library_answer_test)

using namespace stillpoint;
using namespace stillpoint::cli_test;
using Given = std::vector<std::pair<std::string, double>>;

Arguments options(Arguments arguments, const Given& given) {
  for (const auto& [option, value] : given) {
    arguments.push_back(option);
    arguments.push_back(in_full(value));
  }
  return arguments;
}

/// A motion from x0 and v0, of few enough half-cycles to be traced or not.
struct Motion {
  Oscillator oscillator;
  Start start{0, 1};
  bool traced{true};
};

/// Eleven half-cycles and many; rests off centre and where it is; caught and just let go; off
/// centre, and back; counts beyond integers.
const std::vector<Motion> motions{{{1, 0.02, 0.02}},
                                  {{1, 1e-3, 1e-4}},
                                  {{1, 0.3, 0.02}},
                                  {{2, 0, 0}},
                                  {{1, 0.1, 0.1}, {0, 0}},
                                  {{1, 0.1, 0.6}},
                                  {{1, 0.1, 0.5000000000000001}},
                                  {{1, 0.1, 0.5}},
                                  {{1, 0.1, 0.5}, {1, 0}},
                                  {{1, 0.1, 0.5}, {1, 1}},
                                  {{1, 0.1, 0.5}, {-1, -1}},
                                  {{1, 0, 4.9e-13}, {0, 1}, false},
                                  {{1, 4.9e-13, 0}, {0, 1}, false},
                                  {{1, 0, 1e-20}, {0, 1}, false}};

/// At resonance, with sticks, of any phase, and each pulse; from v0 and under that load.
struct Forced {
  Motion motion;
  Excitation excitation;
  Arguments options;
};

const std::vector<Forced> forced{
    {{{1, 0.05, 0.01}, {0, 0.5}}, Harmonic{.k = 0.2, .lambda = 1}, "harmonic --k 0.2 --lambda 1"},
    {{{1, 0.18, 0}, {0, 0.5}},
     Harmonic{.k = 0.2, .lambda = 0.35},
     "harmonic --k 0.2 --lambda 0.35"},
    {{{1, 0, 0}, {0, 0}},
     Harmonic{.k = 1, .lambda = 2, .phase = 0.7},
     "harmonic --k 1 --lambda 2 --phase 0.7"},
    {{{1, 0.1, 0.01}, {0, 0}}, Harmonic{.k = 0.1, .lambda = 1}, "harmonic --k 0.1 --lambda 1"},
    {{{1, 0.1, 0.01}, {0, 0}}, HalfSine{0.5, 2}, "half-sine --k 0.5 --lambda 2"},
    {{{1, 0.1, 0.01}, {0, 0}}, FullSine{0.5, 2}, "full-sine --k 0.5 --lambda 2"},
    {{{1, 0.1, 0.01}, {0, 0}}, Rectangle{0.5, 2}, "rectangle --k 0.5 --lambda 2"}};

/// The report and the trajectory.
void check_motion(const Sandbox& sandbox, const Arguments& asked, SimulationRequest request,
                  bool traced) {
  Arguments command = asked + "--json";
  if (traced) {
    request.samples = 50;
    command = command + "--trajectory motion.csv --samples 50";
  }
  const Simulation answer = simulate(request);
  const Surroundings impatient{.patience = std::chrono::seconds(5)};
  BOOST_TEST(sandbox.succeed(command, impatient).out ==
             report::json_text(report::json(report::MotionReport{
                 request, answer, {}, {}, design::findings_of(request, answer)})));
  BOOST_TEST(
      (!traced || sandbox.read("motion.csv") == report::trajectory_csv(answer.trajectory, {})));
}

Arguments simulated(const Motion& motion) {
  const double p = motion.oscillator.p;
  const double f = motion.oscillator.f;
  const double delta = motion.oscillator.delta;
  return options({"simulate"}, {{"--v0", motion.start.v0},
                                {"--x0", motion.start.x0},
                                {"--p", p},
                                {"--f", f},
                                {"--delta", delta}});
}

/// The options of a task.
Given given(const design::Problem& problem, const design::Limits& limits) {
  Given options{{"--v0", problem.v0}, {"--p", problem.p}, {"--beta", problem.beta}};
  for (const design::LimitKind& kind : design::limit_kinds()) {
    if (const std::optional<double>& limit = limits.*kind.value) {
      options.emplace_back("--" + records::hyphened(kind.field), *limit);
    }
  }
  options.emplace_back("--tolerance", limits.tolerance);
  return options;
}

Arguments with_criterion(Arguments arguments, design::Criterion criterion) {
  return std::move(arguments) + Arguments{"--criterion", std::string(name(criterion))};
}

BOOST_FIXTURE_TEST_CASE(free_motions, Sandbox) {
  for (const Motion& motion : motions) {
    check_motion(*this, simulated(motion), test::simulation_of(motion.oscillator, motion.start),
                 motion.traced);
  }
}

BOOST_FIXTURE_TEST_CASE(forced_motions, Sandbox) {
  for (const auto& [motion, excitation, options] : forced) {
    const SimulationRequest request =
        test::simulation_of(motion.oscillator, motion.start, excitation, 200);
    check_motion(*this, simulated(motion) + "--t-end 200 --excitation" + options, request, true);
  }
}

// Inside the region, beyond each of its edges, at them by a bit, and within limits.
BOOST_FIXTURE_TEST_CASE(regions_and_points, Sandbox) {
  const design::Problem problem{1, 1, 0.8};
  const design::Region region = admissible_region(problem);
  const double delta1 = design::delta1_published(problem, 0.3);
  std::vector<design::RegionRequest> requests{
      {{1, 1, 2}}, {.problem = problem, .f = 0.3}, {.problem = problem, .f = 0.36}};
  for (const auto& [f, delta] :
       std::vector<std::pair<double, double>>{{0.3, 0.4},
                                              {0.3, 0.51},
                                              {0.22, 0.4},
                                              {0.36, 0.4},
                                              {0.3, 0.09},
                                              {0.85, 0.4},
                                              {0.3, 0.07},
                                              {0.3, delta1},
                                              {0.3, std::nextafter(delta1, 1)},
                                              {region.f2, 0.4},
                                              {std::nextafter(region.f2, 0), 0.4}}) {
    for (const design::Limits& limits : std::vector<design::Limits>{{},
                                                                    {.f_max = 0.29},
                                                                    {.delta_max = 0.39},
                                                                    {.acceleration_max = 1.04},
                                                                    {.tolerance = 0.1},
                                                                    {.tolerance = 0.2}}) {
      requests.push_back({.problem = problem, .limits = limits, .f = f, .delta = delta});
    }
  }
  for (design::RegionRequest& request : requests) {
    for (const auto criterion : {design::Criterion::published, design::Criterion::exact}) {
      request.problem.criterion = criterion;
      Given point = given(request.problem, request.limits);
      if (request.f) {
        point.emplace_back("--f", *request.f);
      }
      if (request.delta) {
        point.emplace_back("--delta", *request.delta);
      }
      BOOST_TEST(
          succeed(with_criterion(options({"region"}, point), criterion) + "--json").out ==
          report::json_text(report::json(report::RegionReport{request, design::answer(request)})));
    }
  }
}

BOOST_FIXTURE_TEST_CASE(designs, Sandbox) {
  std::vector<design::DesignRequest> requests{{{1, 1, 0.8}, {}, {}},
                                              {{1, 1, 0.9}, {.f_max = 0.2}, {}},
                                              {{1, 1, 0.9}, {.delta_max = 0.2}, {}}};
  for (const std::string_view objective : names<design::Objective>()) {
    requests.push_back(
        {{1, 1, 0.9}, {.f_max = 0.3, .tolerance = 0.1}, {*parse<design::Objective>(objective)}});
  }
  for (const std::string_view algorithm : design::algorithm_names()) {
    requests.push_back({{1, 1, 0.9}, {}, {.algorithm = std::string(algorithm)}});
  }
  for (design::DesignRequest& request : requests) {
    for (const auto criterion : {design::Criterion::published, design::Criterion::exact}) {
      request.problem.criterion = criterion;
      Arguments asked =
          with_criterion(options({"design"}, given(request.problem, request.limits)), criterion);
      asked = asked + Arguments{"--objective", std::string(name(request.search.objective))};
      if (request.search.algorithm) {
        asked = asked + Arguments{"--algorithm", *request.search.algorithm};
      }
      const auto expected = report::json(answers::answer(answers::DesignTask{request}));
      BOOST_TEST(without_wall_times(reported(asked)) ==
                 without_wall_times(json::parse(expected.dump())));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
