// SPDX-License-Identifier: MIT
#include "record/suite_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

/// Besides the corners of the tolerance box, or its ends if only f or Delta can be off.
constexpr int random_samples = 60;
constexpr std::uint64_t sampling_seed = 20'081;

/// In [-1, 1). The library's distributions differ between implementations.
double between_minus_one_and_one(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1;
}

std::optional<MuchWorse> nearest_much_worse(const Suite& suite, const RecordDesignRequest& request,
                                            const SuitePoint& chosen) {
  constexpr int halvings = 17;  // of a tenth: to the least margin that a design may have
  const auto& [p, f, delta] = chosen.damper;
  for (int k = halvings; k >= 0; --k) {
    const double change = std::ldexp(request.tolerance, -k);
    for (const int of_f : {-1, 0, 1}) {
      for (const int of_delta : {-1, 0, 1}) {
        const SuiteFigures there =
            suite.figures({p, f * (1 + of_f * change), delta * (1 + of_delta * change)});
        if (is_much_worse(there, chosen, request)) {
          return MuchWorse{change, there};
        }
      }
    }
  }
  return std::nullopt;
}

std::optional<SuiteFigures> with_least_friction(const Suite& suite,
                                                const RecordDesignRequest& request,
                                                const SuitePoint& chosen) {
  const auto& [damper, figures] = chosen;
  if (damper.f >= least_friction) {
    return std::nullopt;
  }
  constexpr double worse = 1.1;
  const SuiteFigures there = suite.figures({damper.p, least_friction, damper.delta});
  return !admissible(there, request.limits) ||
                 value_of(there, request.objective) > worse * value_of(figures, request.objective)
             ? std::optional(there)
             : std::nullopt;
}

/// Of what can be off: a zero stays zero.
std::vector<double> both_ends(double value) {
  return value > 0 ? std::vector<double>{-1, 1} : std::vector<double>{0};
}

}  // namespace

Sensitivity sensitivity(const Suite& suite, const RecordDesignRequest& request,
                        const SuitePoint& chosen) {
  const SuiteDamper& damper = chosen.damper;
  std::mt19937_64 random(sampling_seed);
  std::vector<std::pair<double, double>> places;
  for (const double f : both_ends(damper.f)) {
    for (const double delta : both_ends(damper.delta)) {
      places.emplace_back(f, delta);
    }
  }
  for (int i = 0; i < random_samples; ++i) {
    const double f = between_minus_one_and_one(random);
    places.emplace_back(f, between_minus_one_and_one(random));
  }
  Sensitivity result;
  result.tolerance = request.tolerance;
  result.worst = chosen.figures;
  result.much_worse = nearest_much_worse(suite, request, chosen);
  result.with_least_friction = with_least_friction(suite, request, chosen);
  for (const auto& [f, delta] : places) {
    const SuiteFigures there = suite.figures({damper.p, damper.f * (1 + request.tolerance * f),
                                              damper.delta * (1 + request.tolerance * delta)});
    ++result.samples;
    result.admissible += admissible(there, request.limits) ? 1 : 0;
    SuiteFigures& worst = result.worst;
    worst.settled = worst.settled && there.settled;
    if (there.settled) {
      worst.peak = std::max(worst.peak, there.peak);
      worst.acceleration = std::max(worst.acceleration, there.acceleration);
      worst.residual = std::max(worst.residual, there.residual);
      worst.margin = std::min(worst.margin, there.margin);
    }
  }
  return result;
}

double hardly_moving_stroke(double p, double load) {
  constexpr double hardly = 1e-3;
  return hardly * load / (p * p);
}

bool is_much_worse(const SuiteFigures& figures, const SuitePoint& chosen,
                   const RecordDesignRequest& request) {
  constexpr double much = 1.5;
  const double no_stroke = hardly_moving_stroke(chosen.damper.p, peak_load(request.records));
  const auto nothing = [&](SuiteObjective which) {
    return which == SuiteObjective::amplitude  ? no_stroke
           : which == SuiteObjective::residual ? std::max(no_stroke, chosen.figures.peak / 100)
                                               : 0;
  };
  return !figures.settled ||
         std::ranges::any_of(suite_figure_kinds, [&](const SuiteFigureKind& kind) {
           const bool minimised = kind.objective == request.objective;
           const std::optional<double> had =
               minimised ? chosen.figures.*kind.value : request.limits.*kind.limit;
           return had && figures.*kind.value > std::max(much * *had, nothing(kind.objective));
         });
}

}  // namespace stillpoint::design
