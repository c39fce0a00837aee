// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_ranges_test)

// Designs for ranges of k, lambda and p under a pulse, compared with simulations of single pulses.

using namespace stillpoint::design_test;

/// For every k from 0.45 to 0.55, with lambda = p.
PulseRequest rectangles(double beta) {
  return {.problem = {Rectangle{0.55, 1}, 1, beta, Criterion::exact, {.k_low = 0.45}}};
}

/// The cases of lambda move with the ends.
constexpr double of_ends = 1e-4;

/// Long sines, of which the largest f that returns dips and the need jumps in windows of lambda/p
/// that are a per cent wide; most have the least peak, so that f is as large as it may be.
PulseRequest long_task(RandomSource& random) {
  const double p = random.log_uniform(0.1, 10);
  const double k = random.log_uniform(0.1, 10);
  const double lambda = p / random.log_uniform(3, 8);
  PulseRequest request = request_of(pulse_of(2 * (random.pick(3) / 2), k, lambda), 1);
  PulseProblem& problem = request.problem;
  problem.p = p;
  problem.criterion = random.pick(2) == 0 ? Criterion::published : Criterion::exact;
  request = ranged(request, random, random.log_uniform(0.02, 0.25));
  if (random.pick(4) > 0) {
    problem.ranges.k_low = k;
  }
  const Scanned free = scanned(request, problem.pulse, p, 0.02 * k);
  problem.beta = 3 * free.peak_amplitude;
  request.limits.delta_max = random.log_uniform(0.5, 20) * free.need;
  request.search.objective = random.pick(4) == 0 ? Objective::robust : Objective::amplitude;
  return request;
}

/// How many motions are not admissible on the lines through the box and the ranges along f, k,
/// lambda or p, each at the ends of the others.
int bad_on_lines(const PulseRequest& request, const DesignPoint& point, int steps) {
  const double r = point.tolerance * (1 - inset);
  const double least_delta = point.delta * (1 - r) * (1 + inset);
  int bad = 0;
  for (unsigned line = 0; line < 32; ++line) {
    std::array<double, 4> part{};  // of f, k, lambda and p
    for (unsigned i = 0; i < 4; ++i) {
      part.at((line / 8 + 1 + i) % 4) = (line >> i) % 2;
    }
    for (int j = 0; j <= steps; ++j) {
      part.at(line / 8) = static_cast<double>(j) / steps;
      const double f = point.f * (1 + (2 * part[0] - 1) * r);
      const Scanned now = scanned(request, at_parts(request.problem, part[1], part[2], part[3]), f);
      bad += !now.holds || now.need > least_delta ? 1 : 0;
    }
  }
  return bad;
}

BOOST_AUTO_TEST_CASE(what_lies_between_two_looks_of_the_search_is_found) {
  // Near lambda = 0.1607 p the largest f that returns has a dip, between two of the lengths that
  // the search looks at first.
  const PulseRequest dip{
      .problem = {HalfSine{1, 0.158}, 1, 1.34, Criterion::exact, {.lambda_high = 0.178}},
      .limits = {.f_max = 0.09, .delta_max = 0.28},
      .search = {.objective = Objective::amplitude}};
  // Between two f that return there is a gap, 4 % wide, of f that do not: the end of a tongue of
  // longer pulses. No box reaches across it.
  const PulseRequest gap{.problem = {HalfSine{6.085563563, 1.226205191},
                                     7.027432942,
                                     0.396215197,
                                     Criterion::published,
                                     {.lambda_high = 1.301711778},
                                     7.57251306},
                         .limits = {.f_max = 0.682106, .delta_max = 0.0793591},
                         .search = {.objective = Objective::acceleration}};
  // The need over f^2, which is what a weaker pulse asks for, has a maximum where it is not
  // concave.
  const PulseRequest bend{.problem = {HalfSine{0.995780781, 0.05291340021},
                                      0.2891612878,
                                      37.65643277,
                                      Criterion::published,
                                      {0.9496347408, 0.05603690906},
                                      0.3238516763},
                          .limits = {.delta_max = 0.482084},
                          .search = {.objective = Objective::time}};
  for (const PulseRequest& task : {dip, gap, bend}) {
    BOOST_TEST_CONTEXT(context_of(task)) {
      BOOST_TEST(bad_on_lines(task, design::design(task).finding.value().point, 400) == 0);
    }
  }
  PulseRequest one = dip;
  one.problem.ranges = {};
  double least = 1;
  for (int i = 0; i <= 400; ++i) {
    one.problem.pulse = HalfSine{1, 0.158 + 0.02 * i / 400};
    least = std::min(least, design::design(one).intervals.value().front().high);
  }
  // A parabola through the three least of 401 would be wrong by less.
  BOOST_TEST(design::design(dip).finding->point.f == least, tt::tolerance(1e-6));
}

/// The slowest return is inside the range of k, between samples: a scan of k finds none slower.
BOOST_AUTO_TEST_CASE(the_slowest_return_is_that_of_a_scan) {
  constexpr double scan = 1e-6;  // what 400 steps of k may miss
  PulseRequest request{
      .problem = {FullSine{0.2028, 1.737}, 1.79, 0.071, Criterion::published, {.k_low = 0.1835}},
      .search = {.objective = Objective::acceleration}};
  const DesignResult result = design::design(request);
  const DesignPoint& point = result.finding.value().point;
  double slowest = 0;
  for (int i = 0; i <= 400; ++i) {
    const double k = 0.1835 + i * (0.2028 - 0.1835) / 400;
    const auto motion = forced_response({1.79, point.f, point.delta}, {}, FullSine{k, 1.737});
    slowest = std::max(slowest, motion.stop_time.value());
  }
  BOOST_TEST(result.finding->pulse->worst->stop_time == slowest, tt::tolerance(scan));
}

// The last f of the return grows with k, and so does the peak there. With some of these k_high the
// edge for k_low, as a part of k_high, is rounded to an f that does not return.
BOOST_AUTO_TEST_CASE(the_last_return_is_that_of_the_lowest_k) {
  const double k_low = 1.2035138792424556;
  const double lambda = 0.382361453369762;
  const double p = 0.42500357166303254;
  PulseRequest request{.problem = {HalfSine{k_low, lambda}, p, 10, Criterion::exact, {}}};
  const Region weakest = design::design(request).region;
  for (const double k_high : {1.69624, 1.697, 1.7, 1.705, 1.71}) {
    request.problem = {HalfSine{k_high, lambda}, p, 10, Criterion::exact, {.k_low = k_low}};
    const Region region = design::design(request).region;
    BOOST_TEST_CONTEXT("k to " << k_high) {
      const double peak =
          forced_response({p, weakest.f3, 0}, {0, 0}, HalfSine{k_high, lambda}).peak_amplitude;
      BOOST_TEST(region.f3 == weakest.f3, tt::tolerance(inset));
      BOOST_TEST(region.beta_min == peak, tt::tolerance(inset));
    }
  }
}

// A full sine returns for every f below k, so all of a range do below its lowest k.
BOOST_AUTO_TEST_CASE(no_feasible_f_is_above_the_lowest_k_of_full_sines) {
  for (const double lambda : {0.5, 1.0, 2.0, 5.0}) {
    for (const double k_low : {0.1, 0.2, 0.29}) {
      PulseRequest request{
          .problem = {FullSine{0.3, lambda}, 1, 50, Criterion::exact, {.k_low = k_low}}};
      const Region region = design::design(request).region;
      BOOST_TEST_CONTEXT("lambda " << lambda << ", k from " << k_low) {
        BOOST_TEST(region.f3 == k_low, tt::tolerance(1e-15));
        BOOST_TEST(region.f_upper.value() <= region.f3);
        BOOST_TEST(region.f_upper.value() == nearest_to_k * k_low, tt::tolerance(1e-12));
        BOOST_TEST(region.beta_min > 0);
      }
    }
  }
}

// Of a full sine that short, rounding decides which f just below k return.
BOOST_AUTO_TEST_CASE(no_feasible_f_is_above_the_largest_that_returns) {
  struct Row {
    FullSine most;
    double p{};
    double k_low{};
    std::optional<double> f_max{};
  };
  for (const auto& [most, p, k_low, f_max] :
       {Row{{1.2047155469832691, 923013.87476866576}, 1.0436008877526362, 1.2047145962736929},
        Row{{4.7688700627827035, 1621359.0090186559}, 1.9613948994786308, 4.7688694624414243},
        Row{{2.8180520305691834, 372421.94560483337},
            0.41749736560409195,
            2.1505211060951894,
            2.1500585125634753}}) {
    const DesignResult result = design::design(
        PulseRequest{{most, p, 1e3, Criterion::exact, {.k_low = k_low}}, {.f_max = f_max}, {}});
    BOOST_TEST(result.intervals.value().back().high <= result.region.f3);
  }
}

// The rectangle again, with beta = 0.64, which needs k_high - 0.32 <= k_low/2.
BOOST_AUTO_TEST_CASE(ends_of_a_range_of_k_are_mended_to_what_is_known) {
  const DesignResult result = design::design(rectangles(0.64));
  BOOST_TEST(!result.finding.has_value());
  BOOST_TEST(!result.mends_cut_short);
  std::vector<std::string_view> fields;
  for (const Mend& mend : result.mends) {
    fields.push_back(mend.field);
    const double known = mend.field == "k_low"    ? 0.46
                         : mend.field == "k_high" ? 0.545
                         : mend.field == "beta"   ? 0.65
                                                  : mend.value;
    BOOST_TEST(mend.value == known, tt::tolerance(inset));
  }
  BOOST_TEST(fields == (std::vector<std::string_view>{"k_low", "k_high", "lambda", "p", "beta"}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(an_end_that_is_mended_is_moved_as_little_as_possible) {
  for (const int kind : {0, 1}) {
    PulseRequest request{.problem = {pulse_of(kind, 0.55, 0.9), 1, 1e9, Criterion::exact}};
    if (kind == 0) {
      request.problem.ranges.k_low = 0.5;
      request.problem.p_high = 1.1;
    } else {
      request.problem.ranges.lambda_high = 1;
    }
    request.problem.beta = 0.97 * design::design(request).region.beta_min;
    const DesignResult result = design::design(request);
    BOOST_TEST_CONTEXT("kind " << kind) {
      BOOST_TEST(!result.finding.has_value());
      BOOST_TEST(result.mends.size() >= 2U);
      check_mends(request, result.mends, of_ends);
    }
  }
}

// A motion of so long a pulse takes a microsecond. Without an end of the search it would be some
// fifty million of them.
BOOST_AUTO_TEST_CASE(changes_are_not_sought_for_longer_than_a_second) {
  const PulseRequest request{.problem = {FullSine{0.5070917894347563, 0.1905603561180138},
                                         0.7950336998293941,
                                         0.6664802050478071,
                                         Criterion::exact,
                                         {.k_low = 0.3517224658203688},
                                         1.204966300170606},
                             .limits = {.delta_max = 0.018959110927058574}};
  constexpr int most_motions = 1'500'000;
  int motions = 0;
  DesignResult result;
  {
    const Cancellable limited([&] { return ++motions <= most_motions; });
    BOOST_REQUIRE_NO_THROW(result = design::design(request));
  }
  BOOST_TEST(!result.finding.has_value());
  BOOST_TEST(result.mends_cut_short);
  check_mends(request, result.mends, of_ends);
}

BOOST_AUTO_TEST_CASE(wrong_pulses_and_ranges_upside_down_are_refused_by_field) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto field_of = [](double k, double lambda, double p, double beta,
                           const PulseRanges& ranges = {}, std::optional<double> p_high = {}) {
    return refused_field([&] {
      require_valid(PulseProblem{HalfSine{k, lambda}, p, beta, Criterion::exact, ranges, p_high});
    });
  };
  BOOST_TEST(field_of(0.5, 20, 1, 0.05).empty());
  BOOST_TEST(field_of(0.5, 0.2, 1, 0.5).empty());  // lambda < p
  BOOST_TEST(field_of(1, 1, 1, 1, {0.9, 1.1}, 1.2).empty());
  for (const double wrong : {0.0, -0.5, nan}) {
    BOOST_TEST(field_of(wrong, 20, 1, 0.05) == "k");
  }
  for (const double wrong : {0.0, 0.0099, 1.1e12}) {
    BOOST_TEST(field_of(0.5, wrong, 1, 1.5) == "lambda");
  }
  BOOST_TEST(field_of(0.5, 20, -1, 0.05) == "p");
  BOOST_TEST(field_of(0.5, 20, 1, 0) == "beta");
  BOOST_TEST(field_of(0.5, 20, 1, HUGE_VAL) == "beta");
  for (const double wrong : {1.1, 0.0, -1.0, nan}) {
    BOOST_TEST(field_of(1, 1, 1, 1, {wrong, 1.1}, 1.2) == "k");
  }
  for (const double wrong : {0.9, 1e13, nan}) {
    BOOST_TEST(field_of(1, 1, 1, 1, {0.9, wrong}, 1.2) == "lambda");
  }
  for (const double wrong : {0.9, nan}) {
    BOOST_TEST(field_of(1, 1, 1, 1, {0.9, 1.1}, wrong) == "p");
  }
  // The longest is more than a hundred p long.
  BOOST_TEST(field_of(1, 1, 1, 1, {0.9, 1.1}, 101) == "lambda");
}

BOOST_AUTO_TEST_CASE(designs_hold_for_every_long_pulse_of_their_ranges) {
  RandomSource random(20261125);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    const PulseRequest task = long_task(random);
    if (const auto damper = design::damper(task)) {
      ++found;
      BOOST_TEST(bad_on_lines(task, damper->point, 100) == 0,
                 "task " << i << ": " << context_of(task) << ", f " << damper->point.f << ", delta "
                         << damper->point.delta);
    }
  }
  BOOST_TEST(found >= 40);
}

BOOST_AUTO_TEST_SUITE_END()
