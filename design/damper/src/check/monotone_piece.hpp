// SPDX-License-Identifier: MIT
#pragma once

// One monotone piece of a motion, by Boost.Odeint's dopri5 with dense output: for the integrators
// that check a design.

#include <stillpoint/core/elementary.hpp>

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace stillpoint::design {

/// Where the function changes its sign; the end at which it is 0, or `from` if it does not.
template <class Function>
double bracketed_root(const Function& function, double from, double to) {
  const double at_from = function(from);
  const double at_to = function(to);
  if (at_from == 0 || (at_from > 0) == (at_to > 0)) {
    return at_to == 0 ? to : from;
  }
  std::uintmax_t most_evaluations = 200;
  return boost::math::tools::toms748_solve(function, from, to, at_from, at_to,
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .first;
}

using MotionState = std::array<double, 2>;  // x, v

enum class PieceEnd { turn, arrival, time };

/// Where a piece begins, and then where it ends.
struct MonotonePiece {
  double time{0};
  MotionState state{};
  double direction{1};  ///< of v
};

/// odeint's rule for the next step, with a power that is the same on every machine.
class StepAdjuster : public boost::numeric::odeint::default_step_adjuster<double, double> {
 public:
  [[nodiscard]] static double decrease_step(double step, double error, int order) {
    return step * std::max(0.9 * elementary::pow(error, -1.0 / (order - 1)), 0.2);
  }
  [[nodiscard]] static double increase_step(double step, double error, int order) {
    constexpr double most = 5;
    return error < 0.5
               ? step * (0.9 * elementary::pow(std::max(elementary::pow(most, -order), error),
                                               -1.0 / order))
               : step;
  }
};

struct IntegratorTolerance {
  double absolute;
  double relative;
};

/// Follows the piece to where it turns, arrives at x = 0 or `until`, whichever comes first.
/// `motion` is the right-hand side; `look` sees state and time at the end of each step.
template <class Motion, class Look>
PieceEnd follow(MonotonePiece& piece, const Motion& motion, const IntegratorTolerance& tolerance,
                double first_step, double until, const Look& look) {
  namespace odeint = boost::numeric::odeint;
  using Kutta = odeint::runge_kutta_dopri5<MotionState>;
  using ErrorChecker =
      odeint::default_error_checker<double, Kutta::algebra_type, Kutta::operations_type>;
  odeint::dense_output_runge_kutta<
      odeint::controlled_runge_kutta<Kutta, ErrorChecker, StepAdjuster>>
      stepper({ErrorChecker(tolerance.absolute, tolerance.relative), StepAdjuster()});
  stepper.initialize(piece.state, piece.time, first_step);
  const auto at = [&stepper](double t) {
    MotionState now;
    stepper.calc_state(t, now);
    return now;
  };
  const double direction = piece.direction;
  const bool inward = piece.state[0] * direction < 0;
  for (;;) {
    const auto [from, to] = stepper.do_step(motion);
    const double last = std::min(to, until);
    look(at(last), last);
    // A graze dips below x = 0 and is back before the step ends, so where the motion turns, the
    // position at the turn decides, not the one at the end of the step.
    const bool turned = at(last)[1] * direction <= 0;
    const double turn =
        turned ? bracketed_root([&](double t) { return at(t)[1]; }, from, last) : last;
    if (inward && at(turn)[0] * direction >= 0) {
      const double arrival = bracketed_root([&](double t) { return at(t)[0]; }, from, turn);
      piece = {arrival, at(arrival), direction};
      return PieceEnd::arrival;
    }
    if (turned || to >= until) {
      piece = {turn, at(turn), direction};
      return turned ? PieceEnd::turn : PieceEnd::time;
    }
  }
}

}  // namespace stillpoint::design
