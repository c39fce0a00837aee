// SPDX-License-Identifier: MIT
#pragma once

// The last place where a requirement holds, between one where it does and one where it does not.

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

/// The final width of an interval that contains an edge: a relative 1e-14, or 1e-18, which is
/// negligible for an f/k and for a tolerance.
inline double edge_width(double a, double b) {
  constexpr double close = 1e-14;
  constexpr double nothing = 1e-18;
  return std::max(nothing, close * std::max(a, b));
}

/// The ends of an interval, at only one of which something holds.
struct Bracket {
  double holds;
  double fails;
};

/// Halves it to that width.
template <class Holds>
Bracket narrowed(Bracket bracket, const Holds& holds) {
  auto& [holds_at, fails_at] = bracket;
  while (std::abs(fails_at - holds_at) > edge_width(holds_at, fails_at)) {
    const double middle = holds_at + (fails_at - holds_at) / 2;
    (holds(middle) ? holds_at : fails_at) = middle;
  }
  return bracket;
}

/// The end that holds.
template <class Holds>
double last_that_holds(double holds_at, double fails_at, const Holds& holds) {
  return narrowed({holds_at, fails_at}, holds).holds;
}

/// The same where what holds is that a function is >= 0, in a tenth of the steps where it is
/// smooth: Chandrupatla's method, which bisects where the inverse parabola is not to be trusted.
/// Ends at once where `done(holds, fails)`.
template <class Function, class Done>
double last_not_negative(double holds_at, double fails_at, const Function& function,
                         const Done& done) {
  double a = fails_at;
  double b = holds_at;
  double at_a = function(a);
  double at_b = function(b);
  double part = 0.5;
  constexpr int patience = 50;  // where the function jumps, bisection is better than any parabola
  const auto holding = [&] { return at_a >= 0 ? a : b; };
  const auto failing = [&] { return at_a >= 0 ? b : a; };
  for (int step = 0; std::abs(b - a) > edge_width(a, b) && !done(holding(), failing()); ++step) {
    const double now = a + part * (b - a);
    const double at_now = function(now);
    double c = a;
    double at_c = at_a;
    if ((at_now >= 0) != (at_a >= 0)) {
      c = b;
      at_c = at_b;
      b = a;
      at_b = at_a;
    }
    a = now;
    at_a = at_now;
    const double place = (a - b) / (c - b);
    const double value = (at_a - at_b) / (at_c - at_b);
    const bool trusted = value * value < place && (1 - value) * (1 - value) < 1 - place;
    const double least = edge_width(a, b) / 2 / std::abs(b - a);
    part = trusted ? at_a / (at_b - at_a) * at_c / (at_b - at_c) +
                         (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
                   : 0.5;
    part = least < 0.5 && step < patience ? std::clamp(part, least, 1 - least) : 0.5;
  }
  return holding();
}

template <class Function>
double last_not_negative(double holds_at, double fails_at, const Function& function) {
  return last_not_negative(holds_at, fails_at, function, [](double, double) { return false; });
}

}  // namespace stillpoint::design
