// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Scenes under one excitation, together and one by one.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_batch_test)

namespace {

ForcedBatchOptions until(double t_end, const Threads& threads) {
  ForcedBatchOptions options;
  options.scene.t_end = t_end;
  options.threads = threads;
  return options;
}

/// v0, p, f, delta in this order, each one of a few values; many with equal p.
std::vector<Eigen::ArrayXd> random_scenes(Eigen::Index size, Dice& dice) {
  std::vector<Eigen::ArrayXd> columns(4, Eigen::ArrayXd(size));
  for (Eigen::Index i = 0; i < size; ++i) {
    columns[0][i] = dice.once_in(4) ? 0 : dice.sign() * dice.power_of_ten(-1, 0.5);
    columns[1][i] = dice.once_in(2) ? 1 : dice.power_of_ten(-0.5, 0.5);
    columns[2][i] = dice.once_in(6) ? 0 : dice.power_of_ten(-1.5, -0.5);
    columns[3][i] = dice.once_in(3) ? 0 : dice.power_of_ten(-3, -1);
  }
  return columns;
}

const std::vector<Excitation>& excitations() {
  static const std::vector<Excitation> all = [] {
    Dice dice(911);
    return std::vector<Excitation>{Harmonic{0.2, 1, 0.3}, FullSine{0.5, 3},
                                   random_record(dice, 0.3), NoExcitation{}};
  }();
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_scene_is_that_of_forced_response) {
  Dice dice(912);
  for (const Excitation& excitation : excitations()) {
    const auto scenes = random_scenes(150, dice);
    for (const Threads& threads : {Threads(), Threads(1), Threads(2), Threads(3), Threads(7)}) {
      ForcedBatchOptions options = until(40, threads);
      options.hold = threads == Threads(2) ? std::optional(0.07) : std::nullopt;
      const std::vector<ForcedResponse> together =
          forced_batch(scenes[0], scenes[1], scenes[2], scenes[3], excitation, options);
      BOOST_TEST(together.size() == 150U);
      for (Eigen::Index i = 0; i < 150; ++i) {
        BOOST_TEST_CONTEXT("seed 912, scene " << i << ", threads " << threads.value_or(0)) {
          const ForcedResponse alone =
              forced_response({scenes[1][i], scenes[2][i], scenes[3][i], options.hold},
                              {0, scenes[0][i]}, excitation, options.scene);
          BOOST_TEST((together[static_cast<std::size_t>(i)] == alone));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(one_v0_and_p_for_all_and_a_free_end) {
  Dice dice(913);
  const auto scenes = random_scenes(50, dice);
  const Excitation pulse = HalfSine{0.5, 2};
  const auto together = forced_batch(0, 1.5, scenes[2], scenes[3] + 1e-3, pulse);
  for (Eigen::Index i = 0; i < 50; ++i) {
    const Oscillator oscillator{1.5, scenes[2][i], scenes[3][i] + 1e-3};
    BOOST_TEST((together[static_cast<std::size_t>(i)] == forced_response(oscillator, {}, pulse)));
  }
  BOOST_TEST(forced_batch(0, 1, Eigen::ArrayXd(0), Eigen::ArrayXd(0), pulse).empty());
}

BOOST_AUTO_TEST_CASE(errors_name_the_first_scene_at_fault) {
  Eigen::ArrayXd p = Eigen::ArrayXd::Constant(400, 1);
  Eigen::ArrayXd f = Eigen::ArrayXd::Constant(400, 0.1);
  const Eigen::ArrayXd zero = Eigen::ArrayXd::Zero(400);
  f[300] = -1;
  f[301] = -2;
  const auto message = [&](const Excitation& excitation, const ForcedBatchOptions& options) {
    return refusal_of<InputError>(
        [&] { static_cast<void>(forced_batch(zero, p, f, zero, excitation, options)); });
  };
  const Excitation harmonic = Harmonic{0.2, 1};
  for (const int threads : {1, 2, 7}) {
    BOOST_TEST(message(harmonic, until(9, threads)) ==
               "f[300] = -1: must be a number from 0 to 1e+150");
  }
  // Wrong for one p only, although the p before was right.
  p[200] = 1e-140;
  BOOST_TEST(
      message(Harmonic{0.2, 1}, until(9, 1)).starts_with("lambda = 1: lambda / p must be from"));
  BOOST_TEST(message(harmonic, {}).starts_with("t_end = nothing: must be given"));
  BOOST_TEST(message(harmonic, until(9, -1)) == "threads = -1: must be 1 or more");
}

BOOST_AUTO_TEST_CASE(go_on_is_called_in_every_scene) {
  const Eigen::ArrayXd f = Eigen::ArrayXd::Constant(8, 0.01);
  ForcedBatchOptions options = until(1000, 2);
  options.scene.go_on = [](double tau) { return tau < 20; };
  options.scene.ask_every = 1;
  for (const ForcedResponse& response : forced_batch(1, 1, f, f, Harmonic{0.2, 1}, options)) {
    BOOST_TEST(response.cancelled);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
