// SPDX-License-Identifier: MIT
#include "motion.hpp"

// What the structure feels, docs/forced.md section 10: by hand, and along random motions at many
// instants. forced_random_test compares it with 50 digits.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(transmitted_test)

namespace {

/// The largest load on a mass that the notch catches at the start: v0^2 = 0.01 < 2 delta.
void check_caught(const Excitation& excitation, std::optional<double> t_end, double load) {
  const ForcedResponse response = run({1, 0.02, 0.1}, {0, 0.1}, excitation, t_end);
  BOOST_TEST(name(response.outcome) == name(Outcome::caught_at_start));
  BOOST_TEST(response.peak_acceleration == 0);
  close(response.peak_absolute_acceleration, load);
  BOOST_TEST(response.locked_from == 0.0);
  BOOST_TEST_REQUIRE(response.largest_load_while_locked.has_value());
  close(*response.largest_load_while_locked, load);
}

void check_not_locked(const ForcedResponse& response) {
  BOOST_TEST(!response.locked_from);
  BOOST_TEST(!response.largest_load_while_locked);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_mass_that_never_starts_feels_the_load_itself) {
  check_caught(Rectangle{-0.3, 0.5}, 1, 0.3);
  check_caught(Rectangle{-0.3, 0.5}, std::nullopt, 0.3);
  check_caught(HalfSine{0.3, 2}, std::nullopt, 0.3);
  check_caught(HalfSine{0.3, 2}, 0.5, 0.3 * std::sin(1));  // before its crest at pi/4
  check_caught(FullSine{-0.3, 2}, 100, 0.3);
}

BOOST_AUTO_TEST_CASE(a_stop_after_the_load_is_not_locked) {
  const ForcedResponse response = run({1, 0.02, 0.05}, {0, 0}, HalfSine{0.5, 5});
  BOOST_TEST(name(response.outcome) == name(Outcome::stopped_at_zero));
  check_not_locked(response);
  close(response.peak_absolute_acceleration, 0.02 + response.peak_amplitude);
  check_not_locked(run({1, 0.02, 0.1}, {0, 0.1}, Harmonic{0, 1}, 9));
  check_not_locked(run({1, 0.02, 0.1}, {0, 0.1}, NoExcitation{}, 9));
}

BOOST_AUTO_TEST_CASE(without_a_load_it_is_the_relative_acceleration) {
  Dice dice(1111);
  for (int i = 0; i < 300; ++i) {
    const Scene<> scene = i % 2 == 0 ? moderate_scene(dice) : general_start_scene(dice);
    const Response free = free_response(scene.oscillator(), scene.start());
    BOOST_TEST(free.peak_absolute_acceleration == free.peak_acceleration);
    if (!free.stop_time) {
      continue;
    }
    const ForcedResponse forced =
        run(scene.oscillator(), scene.start(), NoExcitation{}, *free.stop_time + 1);
    BOOST_TEST(std::abs(forced.peak_absolute_acceleration - free.peak_acceleration) <=
                   1e-12 * free.peak_acceleration,
               scene);
    check_not_locked(forced);
  }
  BOOST_TEST(free_response({1, 0.3, 0}, {0.2, 0}).peak_absolute_acceleration == 0);
}

namespace {

double load(const auto& kind, double tau) {
  if constexpr (requires { load_at(kind, tau); }) {
    return tau < duration(kind).value_or(HUGE_VAL) ? load_at(kind, tau) : 0;
  } else {
    return 0;
  }
}

std::vector<double> times(const Record& record) {
  std::vector<double> all = record.times;
  for (std::size_t i = 0; record.times.empty() && i < record.values.size(); ++i) {
    all.push_back(static_cast<double>(i) * record.step);
  }
  return all;
}
double load(const Record& record, double tau) {
  const std::vector<double> at = times(record);
  const auto after = std::ranges::upper_bound(at, tau);
  if (after == at.begin() || after == at.end()) {
    return 0;
  }
  const auto i = static_cast<std::size_t>(std::distance(at.begin(), after)) - 1;
  const double part = (tau - at[i]) / (at[i + 1] - at[i]);
  return record.values[i] + (record.values[i + 1] - record.values[i]) * part;
}

/// Where to check between two instants: evenly, close to both ends, and at the samples.
std::vector<double> instants(const Excitation& excitation, double from, double to) {
  constexpr double close_to_an_end = 1e-9;
  constexpr double looks_a_radian = 200;
  const double first = from + (to - from) * close_to_an_end;
  const double last = to - (to - from) * close_to_an_end;
  double looks = 50;
  std::vector<double> all{first, last};
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          looks += std::ceil(looks_a_radian * kind.lambda * (to - from));
        } else if constexpr (requires { kind.values; }) {
          std::ranges::copy_if(times(kind), std::back_inserter(all),
                               [&](double tau) { return tau > first && tau < last; });
        }
      },
      excitation);
  if (const auto lasts = duration(excitation); lasts && *lasts > from && *lasts < to) {
    all.push_back(from + (*lasts - from) * (1 - close_to_an_end));  // W may jump there
  }
  for (double i = 1; i < looks; ++i) {
    all.push_back(from + (to - from) * i / looks);
  }
  return all;
}

double largest_load(const Excitation& excitation, double from, double to) {
  double most = 0;
  for (const double tau : instants(excitation, from, to)) {
    most = std::max(
        most, std::abs(std::visit([&](const auto& kind) { return load(kind, tau); }, excitation)));
  }
  return most;
}

/// By the law of motion at many instants: of a slide f sgn x' + p^2 x, of a stop W.
double looked_at(const Oscillator& oscillator, const Excitation& excitation,
                 const ForcedTrajectory& path) {
  double most = 0;
  std::vector<double> ends;
  for (const Event& event : path.events()) {
    ends.push_back(event.state.tau);
  }
  ends.push_back(path.horizon());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double from = ends[i];
    const double to = ends[i + 1];
    if (!(to - from > 1e-12 * path.horizon())) {
      continue;  // too short to have a middle
    }
    const double v = path.at((from + to) / 2).v;
    if (v == 0) {
      most = std::max(most, largest_load(excitation, from, to));
      continue;
    }
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const double x = path.at(std::min(from + (to - from) * part, to)).x;
      const double force = std::copysign(oscillator.f, v) + oscillator.p * oscillator.p * x;
      most = std::max(most, std::abs(force));
    }
  }
  return most;
}

/// Random scenes, and among them starts at rest, in the dead zone and in the notch.
ForcedScene<> scene_to_feel(Dice& dice) {
  ForcedScene<> scene = random_forced_scene(dice);
  Scene<>& motion = scene.motion;
  if (dice.once_in(5)) {
    motion.x0 = 0;
    motion.delta = motion.v0 * motion.v0 * dice.uniform(0.4, 2);
  } else if (dice.once_in(4)) {
    motion.v0 = 0;
    motion.f = motion.p * motion.p * std::abs(motion.x0) * dice.uniform(0.4, 1.6);
  }
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_motions_feel_what_the_law_of_motion_says_at_many_instants) {
  constexpr double rounding =
      1e-9;  // of the motion, up to a near tie, and of a place close to an end
  constexpr double sampling = 1e-5;  // of a sine between 200 looks a radian: 1/8 200^-2 = 3e-6
  Dice dice(1110);
  int locked = 0;
  int loaded = 0;
  for (int i = 0; i < forced_scene_count(); ++i) {
    const ForcedScene<> scene = scene_to_feel(dice);
    const Excitation& excitation = scene.excitation;
    const Oscillator oscillator = scene.motion.oscillator();
    const ForcedResponse response = run(oscillator, scene.motion.start(), excitation, scene.t_end);
    const ForcedTrajectory path(oscillator, scene.motion.start(), excitation, {scene.t_end});
    const double got = response.peak_absolute_acceleration;
    const double seen = looked_at(oscillator, excitation, path);
    BOOST_TEST_CONTEXT("seed 1110, scene " << i << ": " << scene) {
      BOOST_TEST(got >= seen * (1 - rounding), got << " reported, " << seen << " seen");
      BOOST_TEST(got <= seen * (1 + sampling), got << " reported, " << seen << " seen");
      const bool in_notch = response.outcome == Outcome::caught_at_start ||
                            (response.outcome == Outcome::stopped_at_zero && oscillator.delta > 0 &&
                             *response.half_cycles > 0);
      const double after =
          in_notch ? largest_load(excitation, *response.stop_time, scene.t_end) : 0;
      BOOST_TEST(response.locked_from.has_value() == (after > 0));
      BOOST_TEST(std::abs(response.largest_load_while_locked.value_or(0) - after) <=
                 sampling * after);
      if (response.locked_from) {
        BOOST_TEST(response.locked_from == response.stop_time);
      }
    }
    locked += response.locked_from ? 1 : 0;
    loaded += response.peak_absolute_acceleration >
                      oscillator.f + oscillator.p * oscillator.p * response.peak_amplitude
                  ? 1
                  : 0;
  }
  BOOST_TEST_MESSAGE(locked << " locked, " << loaded << " feel the load most");
  BOOST_TEST(locked > forced_scene_count() / 20);
  BOOST_TEST(loaded > forced_scene_count() / 50);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
