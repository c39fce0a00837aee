// SPDX-License-Identifier: MIT
#include "pulse/neighbours.hpp"

#include <limits>

namespace stillpoint::design {

double clearance_of(const FirstReturn& motion, double turns) {
  constexpr double none = std::numeric_limits<double>::min();
  if (motion.returns && motion.turns <= turns) {
    return motion.clearance;
  }
  return std::min(motion.returns ? -std::min(motion.shortfall, motion.clearance) : motion.clearance,
                  -none);
}

Rated need_of(const FirstReturn& motion, Criterion criterion) {
  return {motion.need(criterion), motion.slope(criterion)};
}

Rated need_over_square(const FirstReturn& motion, Criterion criterion) {
  const auto [need, slope] = need_of(motion, criterion);
  const double f = motion.f;
  return {need / f / f, (slope - 2 * need / f) / f / f};
}

std::optional<Placed> top_of(const Placed& before, const Placed& now, const Placed& after) {
  const double left = now.at - before.at;
  const double right = after.at - now.at;
  const double down_left = (now.value - before.value) / left;
  const double down_right = (now.value - after.value) / right;
  const double curvature = (down_left + down_right) / (left + right);
  const double slope = (down_left * right - down_right * left) / (left + right);
  const double step = slope / (2 * curvature);
  if (!(curvature > 0 && -left < step && step < right)) {
    return std::nullopt;
  }
  return Placed{now.at + step, now.value + slope * step / 2};
}

CubicSlope slope_of_cubic(const Rated& a, const Rated& b, double step) {
  const double chord = (b.value - a.value) / step;
  return {a.slope, 3 * chord - 2 * a.slope - b.slope, 3 * (a.slope + b.slope - 2 * chord)};
}

bool top_of_cubic(const Rated& a, const Rated& b, double step) {
  const auto [start, linear, square] = slope_of_cubic(a, b, step);
  const double root = linear * linear - square * start;
  constexpr double visible = 1e-4;
  const double most = std::max(a.slope, -b.slope) * step * 4 / 27;
  if (!(root > 0) || most <= visible * std::max(a.value, b.value)) {
    return false;
  }
  const double twist = -(linear + std::copysign(std::sqrt(root), linear));
  const double first = twist / square;
  const double second = start / twist;
  const auto inside = [](double x) { return x > 0 && x < 1; };
  return inside(first) || inside(second);
}

bool is_smooth(const FirstReturn& a, const FirstReturn& b, double largest) {
  constexpr double unexplained = 1e-4;
  constexpr double of_change = 0.05;
  if (!(a.returns && b.returns)) {
    return false;
  }
  const double mean_step = (b.f - a.f) / 2;
  const double change = b.exact_need - a.exact_need;
  const double by_slopes = mean_step * (a.need_slope + b.need_slope);
  const double least = std::min(a.exact_need, b.exact_need);
  const bool one_kind = a.turns == b.turns;
  const double allowed =
      unexplained * largest + (one_kind ? of_change * std::min(std::abs(change), least) : 0);
  if (std::abs(change - by_slopes) <= allowed) {
    return true;
  }
  const double faster = b.speed - a.speed;
  const double by_rates = mean_step * (a.need_slope / a.speed + b.need_slope / b.speed);
  return one_kind &&
         std::abs(faster - by_rates) <= of_change * std::min({std::abs(faster), a.speed, b.speed});
}

bool may_jump(const FirstReturn& a, const FirstReturn& b, int depth) {
  constexpr int patient = 5;
  const FirstReturn& fewer = a.turns < b.turns ? a : b;
  const double step = (a.turns < b.turns ? -1 : 1) * fewer.exact_need / fewer.need_slope;
  return a.turns != b.turns && (depth >= patient || (step >= 0 && step <= b.f - a.f));
}

}  // namespace stillpoint::design
