// SPDX-License-Identifier: MIT
#include "hard_case.hpp"

#include <stillpoint/core/free_motion.hpp>

#include <cmath>
#include <cstddef>

// Inputs in the order V0, p, f, Delta; the motion starts at x = 0.

namespace stillpoint::accuracy {

namespace {

enum Metric : std::size_t { peak, acceleration, stop_time, stop_position, arrival_speed };

test::Scene<Exact> scene_of(const Inputs<Exact>& in) {
  return {Exact(0), in[0], in[1], in[2], in[3]};
}

/// The kernel and the same map in 50 digits.
HardCase measured(Metric metric) {
  HardCase result;
  result.metric = test::metric_names.at(metric);
  result.kernel = [metric](const Inputs<double>& in) {
    const Response response = free_response({in[1], in[2], in[3]}, {0, in[0]});
    return test::as_run(response).metrics.at(metric).value();
  };
  result.exact = [metric](const Inputs<Exact>& in) {
    return test::run_in<Exact>(scene_of(in)).metrics.at(metric).value();
  };
  return result;
}

double big_s(const Inputs<double>& in) {
  return std::sqrt(in[2] * in[2] + in[0] * in[1] * in[0] * in[1]);
}

HardCase strong_friction() {
  HardCase now = measured(peak);
  now.name = "peak, friction far above the spring force";
  now.why = "S and f agree in all digits";
  now.naive = "(S - f)/p^2";
  now.inputs = {1, 1, 1e8, 0};
  now.neighbour = [](Dice& dice) {
    const double v0 = dice.power_of_ten(-1, 1);
    const double p = dice.power_of_ten(-1, 1);
    return Inputs<double>{v0, p, v0 * p * dice.power_of_ten(6, 10), 0};
  };
  now.by_naive = [](const Inputs<double>& in) { return (big_s(in) - in[2]) / (in[1] * in[1]); };
  return now;
}

/// f below f3 = V0 p/sqrt 8 by a relative distance of `least` to `most`, stopping on the first
/// return.
Inputs<double> near_f3(Dice& dice, double least, double most) {
  const double v0 = dice.power_of_ten(-1, 1);
  const double p = dice.power_of_ten(-1, 1);
  const double f = v0 * p / std::sqrt(8.0) * (1 - dice.power_of_ten(least, most));
  return {v0, p, f, v0 * v0 / 4};
}

HardCase grazing_arrival() {
  HardCase now = measured(arrival_speed);
  now.name = "arrival that barely gets back to x = 0";
  now.why = "a graze: the term under the root vanishes, and no formula is better than its inputs";
  now.naive = "sqrt(B (B - 2f))/p, B = S - f";
  now.inputs = {1, 1, (1 - 1e-10) / std::sqrt(8.0), 0.25};
  now.neighbour = [](Dice& dice) { return near_f3(dice, -12, -6); };
  now.by_naive = [](const Inputs<double>& in) {
    const double b = big_s(in) - in[2];
    return std::sqrt(b * (b - 2 * in[2])) / in[1];
  };
  return now;
}

HardCase grazing_time() {
  HardCase now = measured(stop_time);
  now.name = "time of that arrival";
  now.why = "the same graze, which costs the time half as many digits";
  now.naive = "(atan2(V0 p, f) + acos(-f/(S - 2f)))/p";
  now.inputs = {1, 1, (1 - 1e-10) / std::sqrt(8.0), 0.25};
  now.neighbour = [](Dice& dice) { return near_f3(dice, -12, -6); };
  now.by_naive = [](const Inputs<double>& in) {
    const double s = big_s(in);
    return (std::atan2(in[0] * in[1], in[2]) + std::acos(-in[2] / (s - 2 * in[2]))) / in[1];
  };
  return now;
}

HardCase swing_back() {
  HardCase now = measured(stop_position);
  now.name = "rest just short of x = 0";
  now.why = "2f - B cancels in any formula, as the condition number shows";
  now.naive = "(2f - (S - f))/p^2";
  now.inputs = {1, 1, (1 + 1e-8) / std::sqrt(8.0), 0.25};
  now.neighbour = [](Dice& dice) {
    Inputs<double> in = near_f3(dice, -12, -6);
    in[2] = in[0] * in[1] / std::sqrt(8.0) * (1 + dice.power_of_ten(-10, -4));
    return in;
  };
  now.by_naive = [](const Inputs<double>& in) {
    return (2 * in[2] - (big_s(in) - in[2])) / (in[1] * in[1]);
  };
  return now;
}

/// From peak to peak by the formulas as printed, with their times; from x = 0 to the rest there.
double plain_stop_time(const Inputs<double>& in) {
  const double p = in[1];
  const double f = in[2];
  double v = in[0];
  double time = 0;
  while (true) {
    const double b = std::sqrt(f * f + v * p * v * p) - f;
    time += std::atan2(v * p, f) / p + std::acos(-f / (b - f)) / p;
    const double square = b * (b - 2 * f) / (p * p) - 2 * in[3];
    if (!(square > 0)) {
      return time;
    }
    v = std::sqrt(square);
  }
}

HardCase long_motion(const std::string& name, const Inputs<double>& inputs, int neighbours) {
  HardCase now = measured(stop_time);
  now.name = name;
  now.why = "each half-cycle inherits the errors of the previous ones";
  now.naive = "the map as published, with an arctangent and an arc cosine per half-cycle";
  now.inputs = inputs;
  now.neighbour = [inputs](Dice& dice) {
    while (true) {
      Inputs<double> in = inputs;
      for (double& value : in) {
        value *= 1 + 1e-2 * dice.uniform(-1, 1);
      }
      const Response response = free_response({in[1], in[2], in[3]}, {0, in[0]});
      // Near a tie rounding decides the count, and the naive loop may go too far.
      if (response.stops_at_zero && response.decision_margin.value() > 1e-9) {
        return in;
      }
    }
  };
  now.by_naive = plain_stop_time;
  now.neighbours = neighbours;
  // For longer motions the condition numbers in 50 digits would take minutes.
  now.alike = inputs[2] < 1e-3;
  return now;
}

HardCase constant_friction_alone() {
  HardCase now = measured(stop_position);
  now.name = "rest after 5e8 half-cycles with constant friction only";
  now.why = "the last peak is a remainder; the condition number is large for any formula";
  now.naive = "A - 2 f/p^2 round(A p^2/(2f))";
  now.inputs = {1, 1, 1e-9, 0};
  now.neighbour = [](Dice& dice) {
    return Inputs<double>{dice.power_of_ten(-0.5, 0.5), 1, dice.power_of_ten(-9.5, -8.5), 0};
  };
  now.by_naive = [](const Inputs<double>& in) {
    const double a = (big_s(in) - in[2]) / (in[1] * in[1]);
    const double step = 2 * in[2] / (in[1] * in[1]);
    const double n = std::round(a / step);
    const double rest = a - n * step;
    return std::fmod(n, 2) == 0 ? rest : -rest;
  };
  return now;
}

HardCase point_friction_alone() {
  HardCase now = measured(arrival_speed);
  now.name = "last arrival after 6e7 passages with point friction only";
  now.why = "V0^2 minus 2 Delta, 6e7 times, which is an exact remainder";
  now.inputs = {1.1, 1, 0, 1e-8};
  now.neighbour = [](Dice& dice) {
    return Inputs<double>{dice.power_of_ten(-0.5, 0.5), 1, 0, dice.power_of_ten(-8.5, -7.5)};
  };
  return now;
}

}  // namespace

std::vector<HardCase> free_cases() {
  return {strong_friction(),
          grazing_arrival(),
          grazing_time(),
          swing_back(),
          long_motion("stop time after 424 half-cycles (scene S2)", {1, 1, 1e-3, 1e-4}, 1000),
          long_motion("stop time after 4e3 half-cycles", {1, 1, 1e-4, 1e-5}, 1000),
          long_motion("stop time after 1e5 half-cycles", {1, 1, 2.5e-6, 1e-6}, 30),
          constant_friction_alone(),
          point_friction_alone()};
}

}  // namespace stillpoint::accuracy
