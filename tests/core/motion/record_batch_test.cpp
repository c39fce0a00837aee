// SPDX-License-Identifier: MIT
#include "instruction_sets.hpp"
#include "motion.hpp"

// Many dampers under one record, each as it is alone: every instruction set of this machine, any
// number of threads. Nothing is rounded differently, so that the values are equal.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(record_batch_test)

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double half_cycles = 1000;  ///< more are not followed to the rest

struct Dampers {
  Eigen::ArrayXd p;
  Eigen::ArrayXd f;
  Eigen::ArrayXd delta;
  double v0{0};
  RecordBatchOptions options;

  explicit Dampers(Eigen::Index size) : p(size), f(size), delta(size) {
    options.half_cycle_limit = half_cycles;
  }

  void set(Eigen::Index i, const Oscillator& oscillator) {
    p[i] = oscillator.p;
    f[i] = oscillator.f;
    delta[i] = oscillator.delta;
  }

  [[nodiscard]] Oscillator oscillator(Eigen::Index i) const {
    const double zeta = options.zeta.size() > 0 ? options.zeta[i] : 0;
    return {p[i], f[i], delta[i], options.hold, zeta, options.breakaway};
  }

  [[nodiscard]] Surface surface(Eigen::Index i) const {
    Surface under = options.surface;
    if (options.notch_width.size() > 0) {
      const double width = options.notch_width[i];
      under.notch_width = width > 0 ? std::optional(width) : std::nullopt;
    }
    return under;
  }

  /// Empty where it has too many half-cycles.
  [[nodiscard]] std::optional<ForcedResponse> alone(Eigen::Index i, const Record& record) const {
    try {
      return forced_response(oscillator(i), {0, v0}, record, {.half_cycle_limit = half_cycles},
                             surface(i));
    } catch (const TooManyHalfCycles&) {
      return std::nullopt;
    }
  }
};

/// There are thousands of values, so only a difference is reported.
void same(const char* what, double got, double expected, Eigen::Index i, const Dampers& dampers) {
  if (got != expected) {
    BOOST_ERROR(what << " = " << got << ", alone " << expected << ", entry " << i << ": p "
                     << dampers.p[i] << ", f " << dampers.f[i] << ", delta " << dampers.delta[i]
                     << ", v0 " << dampers.v0 << ", zeta " << dampers.oscillator(i).zeta
                     << ", width " << dampers.surface(i).notch_width.value_or(0));
  }
}

void is_that_of(const std::optional<ForcedResponse>& alone, const RecordBatchResult& result,
                Eigen::Index i, const Dampers& dampers) {
  const bool rests = alone && alone->outcome != Outcome::never_stops;
  const Outcome outcome = alone ? alone->outcome : Outcome::running;
  if (result.outcome[i] != outcome) {
    BOOST_ERROR(name(result.outcome[i]) << ", alone " << name(outcome) << ", entry " << i);
  }
  if (!rests) {
    return;
  }
  same("peak_amplitude", result.peak_amplitude[i], alone->peak_amplitude, i, dampers);
  same("peak_absolute_acceleration", result.peak_absolute_acceleration[i],
       alone->peak_absolute_acceleration, i, dampers);
  same("jump", result.jump[i], alone->jump, i, dampers);
  same("stop_time", result.stop_time[i], alone->stop_time.value(), i, dampers);
  same("stop_position", result.stop_position[i], alone->stop_position.value(), i, dampers);
  same("locked_from", result.locked_from[i], alone->locked_from.value_or(infinite), i, dampers);
  same("half_cycles", result.half_cycles[i], alone->half_cycles.value(), i, dampers);
  same("turning_points", result.turning_points[i], alone->turning_points.value(), i, dampers);
  same("sticks", result.sticks[i], alone->sticks, i, dampers);
  same("decision_margin", result.decision_margin[i], alone->decision_margin.value_or(infinite), i,
       dampers);
}

/// With each instruction set that this machine has.
void is_identical(Dampers dampers, const Record& record, const std::vector<int>& threads = {1}) {
  std::vector<std::optional<ForcedResponse>> alone;
  for (Eigen::Index i = 0; i < dampers.f.size(); ++i) {
    alone.push_back(dampers.alone(i, record));
  }
  with_each_instruction_set([&] {
    for (const int number : threads) {
      BOOST_TEST_CONTEXT("threads " << number) {
        dampers.options.threads = number;
        const RecordBatchResult result =
            record_batch(dampers.v0, dampers.p, dampers.f, dampers.delta, record, dampers.options);
        BOOST_TEST(result.size() == dampers.f.size());
        for (Eigen::Index i = 0; i < result.size(); ++i) {
          is_that_of(alone[static_cast<std::size_t>(i)], result, i, dampers);
        }
      }
    }
  });
}

/// Sticking and sliding, locked and not, one friction and both, some without any.
Oscillator any_damper(Dice& dice, double k) {
  Oscillator damper;
  damper.p = dice.power_of_ten(-0.5, 0.5);
  damper.f = dice.once_in(8) ? 0 : k * dice.power_of_ten(-3, 0.1);
  damper.delta = dice.once_in(3) ? 0 : k * k / damper.p * dice.power_of_ten(-6, -1);
  return damper;
}

Dampers any_dampers(Eigen::Index size, Dice& dice, double k) {
  Dampers dampers(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    dampers.set(i, any_damper(dice, k));
  }
  return dampers;
}

/// Narrow ones that a mass passes within one interval, wide ones that it hardly leaves, and none.
void give_widths(Dampers& dampers, Dice& dice, double k) {
  dampers.options.notch_width.resize(dampers.f.size());
  for (Eigen::Index i = 0; i < dampers.f.size(); ++i) {
    const double length = k / (dampers.p[i] * dampers.p[i]);
    dampers.options.notch_width[i] = dice.once_in(6) ? 0 : length * dice.power_of_ten(-4, 0.5);
  }
}

/// Little and much, and none.
void give_damping(Dampers& dampers, Dice& dice) {
  dampers.options.zeta.resize(dampers.f.size());
  for (double& zeta : dampers.options.zeta) {
    zeta = dice.once_in(6) ? 0 : dice.power_of_ten(-3, -0.01);
  }
}

BOOST_AUTO_TEST_CASE(random_dampers_under_a_record_are_those_of_the_scalar_kernel) {
  const Record record = record_s5();
  const std::vector<FrictionZone> zones{{1e-3, 0.01}, {0.05, 0.2}};  // inside of a notch or not
  Dice dice(911);
  for (const bool damped : {false, true}) {
    Dampers dampers = any_dampers(200, dice, 0.35);
    if (damped) {
      give_damping(dampers, dice);
    }
    is_identical(dampers, record, {1, 3});
    dampers.v0 = -0.02;  // some of them are caught at the start
    dampers.options.breakaway = 1.5;
    is_identical(dampers, record);
    dampers.options.hold = 0.1;
    is_identical(dampers, record);
    dampers.options.hold.reset();
    give_widths(dampers, dice, 0.35);
    is_identical(dampers, record, {1, 3});
    dampers.options.surface.zones = zones;
    is_identical(dampers, record);
  }
}

BOOST_AUTO_TEST_CASE(a_rest_at_an_edge_is_held_by_the_friction_of_either_side) {
  // p = 1: a start with v0 = 1/2 against f = 3/8, and one with 1/4 against none, turn at x = 1/4 =
  // w/2. There f + Delta/w holds what pushes inwards, f what pushes outwards.
  const Record record{
      {0, 0, 0.125, -0.125, 0.25, -0.375, 0.375, -0.5, 0.25, -0.625, 0.625, 0.5, 0}, 2, {}};
  for (const auto& [f, v0] : {std::pair(0.0, 0.25), std::pair(0.375, 0.5)}) {
    Dampers dampers(24);
    dampers.v0 = v0;
    dampers.options.notch_width = Eigen::ArrayXd::Constant(24, 0.5);
    for (Eigen::Index i = 0; i < 24; ++i) {
      dampers.set(i, {1, f, static_cast<double>(i) / 32});
    }
    is_identical(dampers, record);
    const ForcedResponse rests = dampers.alone(23, {{0, 0}, 2, {}}).value();
    BOOST_TEST(rests.stop_position == 0.25);
    BOOST_TEST((rests.outcome == Outcome::stopped_in_notch));
  }
}

/// With steps far shorter and far longer than a period among them.
BOOST_AUTO_TEST_CASE(random_records_of_any_length) {
  Dice dice(912);
  for (int scene = 0; scene < 150; ++scene) {
    BOOST_TEST_CONTEXT("scene " << scene) {
      const double k = dice.power_of_ten(-1, 1);
      Record record = random_record(dice, k);
      record.step *= scene % 10 == 0 ? dice.power_of_ten(-8, 3) : 1;
      Dampers dampers = any_dampers(1 + scene % 20, dice, k);
      dampers.v0 = dice.once_in(2) ? 0 : k * dice.power_of_ten(-2, 0);
      dampers.options.hold =
          dice.once_in(2) ? std::nullopt : std::optional(k * dice.power_of_ten(-2, 0));
      is_identical(dampers, record);
      dampers.options.hold.reset();
      give_widths(dampers, dice, k);
      is_identical(dampers, record);
      give_damping(dampers, dice);
      is_identical(dampers, record);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_plateau_of_exactly_f_holds_and_one_ulp_more_does_not) {
  // W = 0.1 for three samples, then 0: with f = 0.1 it never moves, with one ulp less it slides.
  const Record record{{0, 0.1, 0.1, 0.1, 0, 0}, 0.5, {}};
  Dampers dampers(32);
  for (Eigen::Index i = 0; i < 32; ++i) {
    const Eigen::Index pair = i / 2;
    const double p = 0.3 + 0.1 * static_cast<double>(pair);
    dampers.set(i, {p, i % 2 == 0 ? 0.1 : std::nextafter(0.1, 0), i % 4 < 2 ? 0 : 1e-3});
  }
  is_identical(dampers, record);
  const RecordBatchResult result =
      record_batch(0, dampers.p, dampers.f, dampers.delta, record, dampers.options);
  for (Eigen::Index i = 0; i < 32; ++i) {
    BOOST_TEST(result.half_cycles[i] == (i % 2 == 0 ? 0 : 1));
  }
}

BOOST_AUTO_TEST_CASE(exact_ties_at_turns_and_at_zero) {
  // Under W = -1 with p = 1, f = 0 the mass turns at x = 2 and comes back to v = 0 at x = 0, both
  // to within rounding of samples, for a step of pi / 2^n.
  Record record{std::vector<double>(40, -1), std::acos(-1.0) / 4, {}};
  Dampers dampers(24);
  for (Eigen::Index i = 0; i < 24; ++i) {
    dampers.set(i, {i % 3 == 0 ? 1.0 : std::nextafter(1.0, i % 3), i % 2 == 0 ? 0 : 0.25,
                    i % 4 < 2 ? 0 : 0.125});
  }
  is_identical(dampers, record);
  record.values.back() = 0;
  is_identical(dampers, record);
}

BOOST_AUTO_TEST_CASE(what_has_no_lanes_runs_all_the_same) {
  Dice dice(914);
  Dampers dampers = any_dampers(10, dice, 1);
  is_identical(dampers, {{0.5, -0.4, 0.2, 0}, 0, {0, 0.3, 1, 2}});
  is_identical(dampers, {{0.5}, 1, {}});
  dampers.delta = dampers.delta + 1e-3;
  dampers.options.surface.notch_width = 0.01;
  is_identical(dampers, {{0.5, -0.4, 0.2, 0}, 0.5, {}});
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named_with_its_entry) {
  Dampers dampers(3);
  dampers.p.setOnes();
  dampers.f.setConstant(0.1);
  dampers.delta.setZero();
  const Record record{{0.5, 0}, 1, {}};
  const auto refused = [&](const char* field, const Record& under) {
    check_refused(field, [&] {
      return record_batch(0, dampers.p, dampers.f, dampers.delta, under, dampers.options);
    });
  };
  refused("record", {{}, 1, {}});
  dampers.f[1] = -1;
  refused("f[1]", record);
  dampers.f[1] = 0;
  dampers.options.notch_width = Eigen::ArrayXd::Zero(3);
  dampers.options.notch_width[2] = -1;
  refused("notch-width[2]", record);
  dampers.options.notch_width = Eigen::ArrayXd::Ones(2);
  refused("notch-width", record);
  dampers.options.notch_width.resize(0);
  dampers.options.zeta = Eigen::ArrayXd::Constant(3, 0.1);
  dampers.options.zeta[1] = 1;
  refused("damping[1]", record);
  dampers.options.zeta.resize(0);
  dampers.p[2] = 0;
  refused("p[2]", record);
}

BOOST_AUTO_TEST_CASE(where_v_only_touches_0) {
  // Once a period while W rises, docs/forced.md (F33): within an interval, or where it ends.
  for (const double step : {0.1, 1.0}) {
    Record record{{}, step, {}};
    for (int i = 0; i * step <= 40; ++i) {
      record.values.push_back(0.05 * (i * step));
    }
    Dampers dampers(24);
    for (int i = 0; i < 24; ++i) {
      const double p = i % 5 == 0 ? std::acos(-1) / 2 : 0.7 + 0.1 * i;
      dampers.set(i, {p, i % 3 * 0.02, i % 2 * 0.01});
    }
    is_identical(dampers, record);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
