// SPDX-License-Identifier: MIT
#include "instruction_sets.hpp"
#include "motion.hpp"

#include <bit>

// The batch and the scalar kernel, bit for bit: every instruction set of this machine, any number
// of threads.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(batch_identity_test)

struct Batch {
  Eigen::ArrayXd v0;
  Eigen::ArrayXd p;
  Eigen::ArrayXd f;
  Eigen::ArrayXd delta;
  Eigen::ArrayXd zeta;  ///< or none
  double breakaway{1};

  explicit Batch(Eigen::Index size) : v0(size), p(size), f(size), delta(size) {}

  [[nodiscard]] Scene<> scene(Eigen::Index i) const { return {0, v0[i], p[i], f[i], delta[i]}; }
  void set(Eigen::Index i, const Scene<>& scene) {
    v0[i] = scene.v0;
    p[i] = scene.p;
    f[i] = scene.f;
    delta[i] = scene.delta;
  }
  [[nodiscard]] BatchResult run(BatchOptions options) const {
    options.zeta = zeta;
    options.breakaway = breakaway;
    return free_batch(v0, p, f, delta, options);
  }
  [[nodiscard]] Response alone(Eigen::Index i) const {
    const double damping = zeta.size() > 0 ? zeta[i] : 0;
    return free_response({p[i], f[i], delta[i], std::nullopt, damping, breakaway}, {0, v0[i]},
                         {.margin = false});
  }
};

/// Bit for bit. There are millions of values, so only a difference is reported.
void same(const char* what, double got, double expected, const Scene<>& scene) {
  if (std::bit_cast<std::uint64_t>(got) != std::bit_cast<std::uint64_t>(expected)) {
    BOOST_ERROR(what << " = " << got << ", alone " << expected << ", scene " << scene);
  }
}

/// An entry as the documentation of BatchResult describes it.
void is_that_of(const Response& alone, const BatchResult& result, Eigen::Index i,
                const Scene<>& scene) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (result.outcome[i] != alone.outcome) {
    BOOST_ERROR(name(result.outcome[i])
                << ", alone " << name(alone.outcome) << ", scene " << scene);
  }
  same("peak_amplitude", result.peak_amplitude[i], alone.peak_amplitude, scene);
  same("half_cycles", result.half_cycles[i], alone.half_cycles.value_or(infinite), scene);
  same("stop_position", result.stop_position[i], alone.stop_position.value_or(0), scene);
  if (result.stop_time.size() != 0) {
    same("stop_time", result.stop_time[i], alone.stop_time.value_or(infinite), scene);
  }
  if (result.peak_absolute_acceleration.size() != 0) {
    same("peak_absolute_acceleration", result.peak_absolute_acceleration[i],
         alone.peak_absolute_acceleration, scene);
  }
}

std::vector<Response> each_alone(const Batch& batch) {
  std::vector<Response> alone;
  for (Eigen::Index i = 0; i < batch.f.size(); ++i) {
    alone.push_back(batch.alone(i));
  }
  return alone;
}

/// Every instruction set, with and without times and acceleration, and these numbers of threads.
void is_identical(const Batch& batch, const std::vector<Threads>& numbers_of_threads) {
  const std::vector<Response> alone = each_alone(batch);
  with_each_instruction_set([&] {
    for (const Threads& threads : numbers_of_threads) {
      for (const bool times : {false, true}) {
        const BatchResult result =
            batch.run({.times = times, .acceleration = times, .threads = threads});
        BOOST_TEST(result.size() == batch.f.size());
        BOOST_TEST(result.stop_time.size() == (times ? batch.f.size() : 0));
        BOOST_TEST(result.peak_absolute_acceleration.size() == result.stop_time.size());
        for (Eigen::Index i = 0; i < result.size(); ++i) {
          is_that_of(alone[static_cast<std::size_t>(i)], result, i, batch.scene(i));
        }
      }
    }
  });
}

/// Any valid scene: one friction or none, caught, no motion, few and many half-cycles.
Scene<> any_scene(Dice& dice) {
  Scene<> scene = moderate_scene(dice);
  scene.f *= dice.once_in(8) ? 0 : dice.power_of_ten(-1, 1);
  scene.delta *= dice.once_in(8) ? 0 : dice.power_of_ten(-2, 0.5);
  scene.v0 *= dice.once_in(20) ? 0 : 1;
  return scene;
}

/// From 1e-140 to 1e140, and near the bounds of the lanes, 2^-64 and 2^64.
Scene<> extreme_scene(Dice& dice) {
  const double far = dice.once_in(2) ? 140 : 20;
  Scene<> scene = moderate_scene(dice);
  const double speed = dice.power_of_ten(-far, far);
  const double time = dice.power_of_ten(-far / 10, far / 10);
  scene.v0 *= speed;
  scene.p /= time;
  scene.f *= speed / time;
  scene.delta *= speed * speed;
  return scene;
}

template <class Scenes>
Batch batch_of(Eigen::Index size, const Scenes& scenes) {
  Batch batch(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    batch.set(i, scenes());
  }
  return batch;
}

/// Next to a tie.
Scene<> tied_scene(Dice& dice) {
  while (true) {
    if (const auto scene = near_tie(moderate_scene(dice), dice)) {
      return *scene;
    }
  }
}

/// Up to some 1e5 half-cycles, more of them in one lane than in a block of the others.
Scene<> long_or_short_scene(Dice& dice) {
  Scene<> scene = moderate_scene(dice);
  const double little = dice.once_in(200) ? 1e-4 : dice.power_of_ten(-1.5, 0);
  scene.f *= little;
  scene.delta *= little * little;
  return scene;
}

void give_damping(Batch& batch, double breakaway, Dice& dice) {
  batch.breakaway = breakaway;
  batch.zeta.resize(batch.f.size());
  for (double& zeta : batch.zeta) {
    zeta = dice.once_in(20)  ? 0
           : dice.once_in(3) ? dice.power_of_ten(-12, -1)
                             : dice.below(991) / 1e3;
  }
}

BOOST_AUTO_TEST_CASE(random_entries_are_those_of_the_scalar_kernel) {
  Dice dice(901);
  is_identical(batch_of(20000, [&] { return any_scene(dice); }), {1});
  is_identical(batch_of(10000, [&] { return extreme_scene(dice); }), {1});
  is_identical(batch_of(2000, [&] { return tied_scene(dice); }), {1});
  is_identical(batch_of(6000, [&] { return long_or_short_scene(dice); }), {1, 2});
}

BOOST_AUTO_TEST_CASE(each_oscillator_has_a_damping_of_its_own) {
  Dice dice(908);
  for (const Eigen::Index size : {10000, 1000, 1, 63, 64, 65, 129}) {
    Batch batch = batch_of(size, [&] { return any_scene(dice); });
    give_damping(batch, size == 1000 ? 1.2 : 1, dice);
    is_identical(batch, {2});
  }
  Batch extreme = batch_of(1000, [&] { return extreme_scene(dice); });
  give_damping(extreme, 1, dice);
  is_identical(extreme, {1});
}

BOOST_AUTO_TEST_CASE(a_notch_too_weak_for_the_cube_of_a_speed_stops_at_zero_too) {
  Batch batch = batch_of(70, [] { return Scene<>{0, 1, 1, 0, 1e-300}; });
  batch.zeta = Eigen::ArrayXd::LinSpaced(70, 0.02, 0.98);
  is_identical(batch, {1});
  for (const double time : batch.run({}).stop_time) {
    BOOST_TEST(std::isfinite(time));
  }
}

BOOST_AUTO_TEST_CASE(exact_ties_stop_at_zero) {
  // phi = 7, V0 = 24: r = 25, w^2 = (25 - 21)(25 - 7) = 72, so that delta = 36 takes all of it. A
  // notch one ulp smaller lets it pass. phi = 1, r = 3 for V0^2 = 8 is the tie of the return.
  Batch batch(16);
  for (Eigen::Index i = 0; i < 16; ++i) {
    batch.set(i, {0, i % 3 == 0 ? -24.0 : 24.0, 1, 7, i % 2 == 0 ? 36.0 : nudged(36, -1)});
  }
  is_identical(batch, {1});
  const BatchResult result = batch.run({});
  for (Eigen::Index i = 0; i < 16; ++i) {
    BOOST_TEST(result.half_cycles[i] == (i % 2 == 0 ? 1 : 2));
  }
}

BOOST_AUTO_TEST_CASE(any_size_and_any_number_of_threads) {
  Dice dice(905);
  for (const Eigen::Index size : {0, 1, 2, 3, 7, 8, 9, 15, 17, 63, 64, 65, 129, 1000}) {
    is_identical(batch_of(size, [&] { return any_scene(dice); }), {1, 2});
  }
  for (const Eigen::Index size : {4095, 4096, 4097, 13000}) {
    is_identical(batch_of(size, [&] { return any_scene(dice); }), {Threads(), 1, 2, 3, 7});
  }
}

BOOST_AUTO_TEST_CASE(one_v0_and_p_for_all_and_one_for_each_give_the_same) {
  Dice dice(906);
  for (const double p : {1.0, 0.3}) {
    Batch batch = batch_of(3000, [&] { return any_scene(dice); });
    batch.v0.setConstant(-1.25);
    batch.p.setConstant(p);
    const std::vector<Response> alone = each_alone(batch);
    with_each_instruction_set([&] {
      const BatchResult result = free_batch(-1.25, p, batch.f, batch.delta, {.times = true});
      for (Eigen::Index i = 0; i < result.size(); ++i) {
        is_that_of(alone[static_cast<std::size_t>(i)], result, i, batch.scene(i));
      }
    });
  }
}

BOOST_AUTO_TEST_CASE(results_go_where_the_caller_keeps_them) {
  Dice dice(907);
  const Batch batch = batch_of(500, [&] { return any_scene(dice); });
  BatchResult result = batch.run({.times = true});
  const double* const place = result.peak_amplitude.data();
  free_batch(batch.v0, batch.p, batch.f, batch.delta, {.times = true}, result);
  BOOST_TEST(result.peak_amplitude.data() == place);
  // A part of an array is a batch as well.
  free_batch(batch.v0.head(9), batch.p.head(9), batch.f.head(9), batch.delta.head(9), {}, result);
  BOOST_TEST(result.size() == 9);
  BOOST_TEST(result.stop_time.size() == 0);
  for (Eigen::Index i = 0; i < 9; ++i) {
    is_that_of(response(batch.scene(i)), result, i, batch.scene(i));
  }
}

BOOST_AUTO_TEST_CASE(a_damped_batch_refuses_what_a_motion_refuses) {
  Batch batch = batch_of(70, [] { return Scene<>{0, 1, 1, 0.1, 0.01}; });
  batch.zeta = Eigen::ArrayXd::Constant(70, 0.05);
  BOOST_CHECK_THROW((void)batch.run({.half_cycle_limit = 2}), TooManyHalfCycles);
  batch.zeta[66] = 1.5;
  check_contains(refusal_of<InputError>([&] { (void)batch.run({}); }), {"damping"});
  batch.zeta[66] = 0.05;
  batch.breakaway = 0.5;
  check_contains(refusal_of<InputError>([&] { (void)batch.run({}); }), {"breakaway"});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
