// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/record_batch.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <limits>
#include <tuple>

// What holds for every motion: its energy only falls, no change below half of the decision margin
// changes how it ends, and a batch has the bits of the scalar kernel.

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;

constexpr double most_half_cycles = 2000;

struct Scene {
  double x0, v0, p, f, delta;

  [[nodiscard]] Oscillator oscillator() const { return {p, f, delta}; }
  [[nodiscard]] Start start() const { return {x0, v0}; }
  [[nodiscard]] Response response() const {
    return free_response(oscillator(), start(), {.half_cycle_limit = most_half_cycles});
  }
};

std::string shown(const Scene& scene) {
  return fmt::format("{{x0 {}, v0 {}, p {}, f {}, delta {}}}", scene.x0, scene.v0, scene.p, scene.f,
                     scene.delta);
}

/// Moderate, then moved far away in size and time, and now and then any numbers.
Scene any_scene(Numbers& numbers) {
  if (numbers.once_in(16)) {
    return {numbers.raw(), numbers.raw(), numbers.raw(), numbers.raw(), numbers.raw()};
  }
  const bool far = numbers.once_in(4);
  const double speed = far ? numbers.power_of_ten(-140, 140) : numbers.power_of_ten(-2, 2);
  const double p = numbers.power_of_ten(-2, 2) * (far ? numbers.power_of_ten(-9, 9) : 1);
  Scene scene{0, speed, p, speed * p * numbers.power_of_ten(-3, 0.6),
              speed * speed * numbers.power_of_ten(-4, -0.2)};
  scene.f *= numbers.once_in(8) ? 0 : 1;
  scene.delta *= numbers.once_in(8) ? 0 : 1;
  if (numbers.once_in(3)) {
    scene.x0 = numbers.uniform(-1, 1) * speed / p * numbers.power_of_ten(-1.5, 1);
    scene.v0 *= numbers.uniform(-1, 1);
  }
  return scene;
}

auto end_of(const Response& motion) {
  return std::tuple(motion.outcome, motion.half_cycles, motion.turning_points);
}

/// The last f or delta before the end of the motion changes, and some steps beside it.
void move_to_a_tie(Scene& scene, Numbers& numbers) {
  double Scene::*const input = numbers.once_in(2) ? &Scene::f : &Scene::delta;
  const auto end = end_of(scene.response());
  Scene far = scene;
  far.*input *= numbers.uniform(0.5, 2);
  if (end_of(far.response()) == end) {
    return;
  }
  while (true) {
    Scene between = scene;
    between.*input = scene.*input + (far.*input - scene.*input) / 2;
    if (between.*input == scene.*input || between.*input == far.*input) {
      scene.*input = numbers.beside(scene.*input);
      return;
    }
    (end_of(between.response()) == end ? scene : far) = between;
  }
}

void require_margin(const Scene& scene, const Response& motion, Numbers& numbers) {
  constexpr double smallest = 1e-12;  // below, the scene's own rounding counts
  const double margin = motion.decision_margin.value_or(0);
  for (int i = 0; margin >= smallest && i < 4; ++i) {
    const auto changed = [&](double input) {
      return input * (1 + 0.499 * margin * (numbers.once_in(2) ? 1 : numbers.uniform(-1, 1)));
    };
    const Scene moved{changed(scene.x0), changed(scene.v0), changed(scene.p), changed(scene.f),
                      changed(scene.delta)};
    bool counted = true;
    Response other;
    counted = accepted([&] { other = moved.response(); });
    require(!counted || end_of(other) == end_of(motion), "margin {} of {}, but {} ends otherwise",
            margin, shown(scene), shown(moved));
  }
}

/// v^2/2 + p^2 x^2/2 less what each arc of it costs at least: nothing.
void require_falling_energy(const Scene& scene) {
  constexpr double rounding = 1e-13;  // of x and v, relative to the largest in the arc
  const Trajectory path(scene.oscillator(), scene.start(), {{}, 200});
  double before = std::numeric_limits<double>::infinity();
  for (const State& state : path.sampled(20)) {
    const double speed = std::hypot(state.v, scene.p * state.x);
    require(speed <= before * (1 + rounding), "the energy of {} rises at tau = {}: {} after {}",
            shown(scene), state.tau, speed, before);
    before = speed;
  }
}

void require_valid_metrics(const Scene& scene, const Response& motion) {
  constexpr double rounding = 1e-15;  // p x and back, and the dead zone
  const double dead_zone = scene.f / scene.p / scene.p;
  require(std::isfinite(motion.peak_amplitude) && std::isfinite(motion.peak_acceleration) &&
              std::isfinite(motion.peak_absolute_acceleration) &&
              motion.peak_amplitude >= std::abs(scene.x0) * (1 - rounding),
          "the peaks of {}", shown(scene));
  require(motion.stop_position.has_value() == (motion.outcome != Outcome::never_stops) &&
              std::abs(motion.stop_position.value_or(0)) <= dead_zone * (1 + rounding) &&
              motion.stops_at_zero == (motion.outcome == Outcome::stopped_at_zero),
          "the rest of {}", shown(scene));
  require(motion.stop_time.value_or(0) >= 0 && std::isfinite(motion.stop_time.value_or(0)),
          "the stop time of {}", shown(scene));
}

void move(Numbers& numbers) {
  Scene scene = any_scene(numbers);
  if (numbers.once_in(3)) {
    move_to_a_tie(scene, numbers);
  }
  const Response motion = scene.response();
  require_valid_metrics(scene, motion);
  require_margin(scene, motion, numbers);
  if (motion.outcome != Outcome::never_stops && motion.half_cycles < 100) {
    require_falling_energy(scene);
  }
}

/// Some motions from x = 0, each of them alone and all of them in lanes.
void move_in_lanes(Numbers& numbers) {
  const Eigen::Index size = 1 + numbers.below(12);
  Eigen::ArrayXd v0(size), p(size), f(size), delta(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    Scene scene = any_scene(numbers);
    scene.x0 = 0;
    v0[i] = scene.v0;
    p[i] = scene.p;
    f[i] = scene.f;
    delta[i] = scene.delta;
  }
  const BatchResult batch = free_batch(
      v0, p, f, delta,
      {.times = true, .acceleration = true, .half_cycle_limit = most_half_cycles, .threads = 1});
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < size; ++i) {
    const Scene scene{0, v0[i], p[i], f[i], delta[i]};
    const Response alone = scene.response();
    require(batch.outcome[i] == alone.outcome &&
                same_bits(batch.peak_amplitude[i], alone.peak_amplitude) &&
                same_bits(batch.half_cycles[i], alone.half_cycles.value_or(infinite)) &&
                same_bits(batch.stop_position[i], alone.stop_position.value_or(0)) &&
                same_bits(batch.stop_time[i], alone.stop_time.value_or(infinite)) &&
                same_bits(batch.peak_absolute_acceleration[i], alone.peak_absolute_acceleration),
            "entry {} of {} is not {} alone", i, size, shown(scene));
  }
}

/// The same under a short record.
void move_under_record(Numbers& numbers) {
  Record record;
  record.step = numbers.power_of_ten(-2, 1);
  record.values.resize(2 + numbers.below(40));
  const double size = numbers.power_of_ten(-2, 2);
  for (double& value : record.values) {
    value = numbers.once_in(5) ? 0 : size * numbers.uniform(-1, 1);
  }
  const double v0 = numbers.once_in(2) ? size * numbers.uniform(-3, 3) : 0;
  const std::optional<double> hold =
      numbers.once_in(2) ? std::optional(size * numbers.power_of_ten(-1, 1)) : std::nullopt;
  const Eigen::Index count = 1 + numbers.below(10);
  Eigen::ArrayXd p(count), f(count), delta(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    p[i] = numbers.power_of_ten(-1, 1);
    f[i] = numbers.once_in(8) ? 0 : size * numbers.power_of_ten(-2, 1);
    delta[i] = numbers.once_in(8) ? 0 : size * size * numbers.power_of_ten(-4, 0);
  }
  const RecordBatchResult batch = record_batch(
      v0, p, f, delta, record, {.hold = hold, .half_cycle_limit = most_half_cycles, .threads = 1});
  for (Eigen::Index i = 0; i < count; ++i) {
    if (batch.outcome[i] == Outcome::running || batch.outcome[i] == Outcome::never_stops) {
      continue;
    }
    const ForcedResponse alone = forced_response({p[i], f[i], delta[i], hold}, {0, v0}, record,
                                                 {.half_cycle_limit = most_half_cycles});
    require(batch.outcome[i] == alone.outcome &&
                same_bits(batch.peak_amplitude[i], alone.peak_amplitude) &&
                same_bits(batch.peak_absolute_acceleration[i], alone.peak_absolute_acceleration) &&
                same_bits(batch.stop_position[i], alone.stop_position.value()) &&
                same_bits(batch.half_cycles[i], alone.half_cycles.value()) &&
                same_bits(batch.sticks[i], alone.sticks),
            "entry {} of {} under a record is not the motion alone: p {}, f {}, delta {}, v0 {}", i,
            count, p[i], f[i], delta[i], v0);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Numbers numbers(data, size);
  const unsigned kind = numbers.below(3);
  accepted([&] { (kind == 0 ? move : kind == 1 ? move_in_lanes : move_under_record)(numbers); });
  return 0;
}
