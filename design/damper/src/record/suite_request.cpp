// SPDX-License-Identifier: MIT
#include "record/suite_request.hpp"

#include "record/suite.hpp"
#include "region/edges.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace stillpoint::design {

namespace {

void require_range(const char* field, const Interval& range, double low, double high) {
  require_within(field, range.low, low, high);
  require_within(field, range.high, low, high);
  if (range.high < range.low) {
    throw InputError(field, fmt::format("{}:{}", range.low, range.high),
                     "must have the lower end first");
  }
}

void require_limit(const char* field, const std::optional<double>& limit, double least) {
  if (limit) {
    require_within(field, *limit, least, largest_speed);
  }
}

/// No farther than what can be manufactured.
void keep_below(std::optional<Interval>& range, const std::optional<double>& most,
                const char* field) {
  if (!most) {
    return;
  }
  require_within(field, *most, 0, largest_speed);
  range = range.value_or(Interval{0, *most});
  if (range->low > *most) {
    throw InputError(field, *most,
                     fmt::format("must be at least {}, where the search begins", range->low));
  }
  range->high = std::min(range->high, *most);
}

/// Periods after the end of a record in which a mass must rest if its residual is to be the least:
/// one that hardly loses energy rests anywhere.
constexpr double latest_rest = 20;

/// A notch without a width takes the whole of a hit, and friction holds the mass under a pulse that
/// must bring it back. What is searched stays below; a damper to judge may take all of a hit.
void require_start(RecordDesignRequest& request, const LoadCase& load_case) {
  constexpr double below_start = 1 - 1e-9;
  const auto bound = [&](std::optional<double>& most, double value, double held, const char* field,
                         const std::optional<Interval>& searched) {
    most = std::min(most.value_or(HUGE_VAL), value);
    if (searched && searched->low > *most && !request.judges) {
      throw InputError(field, searched->low,
                       fmt::format("must be less than {} so that the {} {} moves the mass", held,
                                   load_case.v0 ? "hit of case" : "pulse of case", load_case.name));
    }
  };
  const double part = load_case.weakest > 0 ? load_case.weakest : 1;
  if (load_case.v0 && !request.width) {
    const double v0 = part * *load_case.v0;
    const double held = v0 * v0 / 2;
    bound(request.delta_start, request.judges ? largest_delta_of_start(v0) : below_start * held,
          held, "delta", request.delta);
  }
  if (load_case.pulse && load_case.limits.residual == 0.0) {
    const double held = part * peak_load(*load_case.pulse) / request.breakaway;
    bound(request.f_start, below_start * held, held, "f", request.f);
  }
}

/// How long a swing without friction takes.
double half_turn(double p, double zeta) {
  return std::numbers::pi / p / std::sqrt((1 - zeta) * (1 + zeta));
}

/// The largest |x| without a damper.
double free_peak(const LoadCase& load_case, const RecordDesignRequest& request) {
  const double p = request.p.low;
  const double zeta = request.zeta.low;
  double peak = 0;
  for (const CaseMotion& motion : motions_of(load_case)) {
    const double t_end = load_case.of_records()
                             ? duration(motion.load).value()
                             : duration(motion.load).value_or(0) + half_turn(p, zeta);
    peak = std::max(
        peak, forced_response({p, 0, 0, {}, zeta}, motion.start, motion.load, {.t_end = t_end})
                  .peak_amplitude);
  }
  return peak;
}

/// Where a hit that must come back turns with the largest friction that lets it, half of the
/// spring's force, (4) of theory.md: damping only brings it nearer and allows less. 0 for other
/// loads.
double farthest_turn(const LoadCase& load_case, double p) {
  const bool comes_back = load_case.v0 && load_case.limits.residual == 0.0;
  return comes_back ? *load_case.v0 / (std::numbers::sqrt2 * p) : 0;
}

/// The largest friction that may be of use: under more a load moves nothing, or a hit moves the
/// mass by less than half of its limit; nor does the mass come back where it must, after a pulse to
/// one side with more than the spring's force. A full sine pushes it back as well.
double most_friction(const RecordDesignRequest& request) {
  const double p = request.p.high;
  double most = 0;
  double comes_back = HUGE_VAL;
  for (const LoadCase& each : request.cases) {
    double now = peak_load(each, p) / (each.v0 ? 1 : request.breakaway);
    if (each.v0 && each.limits.peak) {
      now = std::max(now, *each.v0 * *each.v0 / *each.limits.peak);
    }
    most = std::max(most, now);
    if (const double turn = farthest_turn(each, p); turn > 0) {
      comes_back = std::min(comes_back, p * p * turn / 2);
    } else if (each.pulse && each.limits.residual == 0.0) {
      constexpr double pushed = 16;  // so much more is searched of a full sine
      const double part = std::holds_alternative<FullSine>(*each.pulse) ? pushed : 1;
      comes_back = std::min(comes_back, part * p * p * free_peak(each, request));
    }
  }
  return std::min(most, comes_back);
}

/// The energy with which a mass may arrive.
double most_delta(const RecordDesignRequest& request) {
  double most = 0;
  for (const LoadCase& each : request.cases) {
    double peak =
        each.of_records() && each.limits.peak ? *each.limits.peak : free_peak(each, request);
    if (each.limits.peak) {
      peak = std::min(peak, std::max(*each.limits.peak, farthest_turn(each, request.p.low)));
    }
    const double speed = request.p.high * peak;
    most = std::max(most, speed * speed / 2 + peak_load(each, request.p.high) * peak);
  }
  return most;
}

void require_spread(const char* field, const Spread& spread) {
  require_within(field, spread.below, 0, 1 - 1e-9);
  require_within(field, spread.above, 0, 1);
}

/// What a box is to grow to.
void require_growth(const RecordDesignRequest& request) {
  const SuiteTolerance& of = request.tolerance;
  if (of.f.below + of.f.above + of.delta.below + of.delta.above == 0) {
    throw InputError("tolerance", 0.0,
                     "must be above 0 with the objective robust, which enlarges it");
  }
  if (std::ranges::none_of(suite_figure_kinds, [&](const SuiteFigureKind& kind) {
        return limits_any(request, kind.limit);
      })) {
    throw InputError::missing("max-displacement",
                              "give a limit, of stroke, residual or acceleration, that bounds the "
                              "tolerance");
  }
}

/// With more damping a mass returns with less than a thousandth of its speed, and a friction of a
/// millionth of its load decides where it rests.
constexpr double most_damped_return = 0.9;

void require_valid(const LoadCase& load_case, const RecordDesignRequest& request) {
  design::require_valid(load_case);
  if (load_case.weakest != 0 || load_case.of_records()) {
    require_within("weakest", load_case.weakest, load_case.of_records() ? 1 : least_weakest, 1);
  }
  const SuiteLimits& limits = load_case.limits;
  require_limit("beta", limits.peak, smallest_speed);
  require_limit("acceleration-max", limits.acceleration, smallest_speed);
  require_limit("residual", limits.residual, 0);
  require_limit("jump-max-v", limits.jump, 0);
  require_limit("arrivals", limits.passages, 0);
  if (request.width && !load_case.of_records() && limits.residual == 0.0) {
    throw InputError("residual", 0.0,
                     fmt::format("must be greater than 0{} with a notch that has a width, which "
                                 "stops the mass beside x = 0: give a residual",
                                 load_case.name.empty() ? "" : " in the case " + load_case.name));
  }
  if (request.width && limits.jump) {
    throw InputError("jump-max-v", *limits.jump,
                     "must be left out where the notch has a width, in which no speed jumps");
  }
}

/// Of a notch whose friction is a number, with springs and dampers nearby as well.
void require_width(const RecordDesignRequest& request) {
  constexpr double nearby = 1e5;
  const double least =
      nearby * std::max(smallest_speed, request.delta->high / largest_speed) / request.p.low;
  if (request.width->low < least) {
    throw InputError("notch-width", request.width->low,
                     fmt::format("must be at least {:.4g}, for a friction of a size that can be "
                                 "computed with",
                                 least));
  }
}

}  // namespace

bool counts_the_notch(const RecordDesignRequest& request) {
  const bool asks = request.objective == SuiteObjective::acceleration ||
                    limits_any(request, &SuiteLimits::acceleration);
  return !asks || request.width || limits_any(request, &SuiteLimits::jump) ||
         std::ranges::none_of(request.cases, &LoadCase::of_records);
}

void require_valid(const RecordDesignRequest& request) {
  if (request.cases.empty()) {
    throw InputError::missing("cases", "give at least one");
  }
  require_range("p", request.p, smallest_speed, largest_speed);
  for (const LoadCase& each : request.cases) {
    require_valid(each, request);
  }
  require_spread("tolerance-f", request.tolerance.f);
  require_spread("tolerance-delta", request.tolerance.delta);
  require_spread("tolerance-width", request.tolerance.width);
  require_spread("tolerance-period", request.tolerance.period);
  require_spread("spring", request.spring);
  require_range("damping", request.zeta, 0, largest_zeta);
  require_within("breakaway", request.breakaway, 1, largest_breakaway);
  if (request.objective == SuiteObjective::robust && !request.judges && !request.maps &&
      request.parts.empty()) {
    require_growth(request);
  }
  if (request.zeta.high > most_damped_return &&
      !std::ranges::all_of(request.cases, &LoadCase::of_records)) {
    throw InputError("damping", request.zeta.high,
                     fmt::format("must be at most {} for a hit or a pulse, after which the mass "
                                 "would creep to its rest",
                                 most_damped_return));
  }
  if (request.objective == SuiteObjective::time &&
      std::ranges::any_of(request.cases, &LoadCase::of_records)) {
    throw InputError("objective", "time",
                     "is for hits and pulses: under records the mass rests somewhere when the "
                     "record ends, and its residual counts");
  }
  if (request.width) {
    require_range("notch-width", *request.width, 1e-150, 1e150);
  }
  const double slowest = half_turn(1, request.zeta.low) / largest_speed;
  if (!(request.p.low >= slowest)) {
    throw InputError("p", request.p.low,
                     fmt::format("must be at least {:.4g} where motions are simulated", slowest));
  }
  require_within("scan_points", static_cast<double>(request.scan_points), 1, 1e8);
}

double most_in_dead_zone(const RecordDesignRequest& request, double p) {
  double most = HUGE_VAL;
  for (const LoadCase& each : request.cases) {
    if (each.v0 && each.limits.residual.value_or(0) > 0 && each.limits.peak) {
      constexpr double below = 1 - 1e-9;
      most = std::min(most, below * p * *each.limits.peak * p / request.breakaway);
    }
  }
  return most;
}

double softest(const RecordDesignRequest& request, double p) {
  return p / (1 + combined(request.spring, request.tolerance.period).above);
}

void bound_starts(RecordDesignRequest& request) {
  request.f_start = request.delta_start = std::nullopt;
  for (const LoadCase& each : request.cases) {
    require_start(request, each);
  }
}

RecordDesignRequest completed(RecordDesignRequest request) {
  if (!request.parts.empty()) {
    request.judges = true;
    const auto [least_f, most_f] = std::ranges::minmax(request.parts, {}, &Part::f);
    const auto [least, most] = std::ranges::minmax(request.parts, {}, &Part::delta);
    request.f = Interval{least_f.f, most_f.f};
    request.delta = Interval{least.delta, most.delta};
  }
  for (LoadCase& each : request.cases) {
    each.combine = each.of_records() ? each.combine.value_or(default_combine(each.records.size()))
                                     : Combine::max;
    if (request.objective == SuiteObjective::residual && each.of_records()) {
      each.limits.late = latest_rest;
    }
  }
  bound_starts(request);
  if (!request.judges) {
    keep_below(request.f, request.f_max, "f-max");
    keep_below(request.delta, request.delta_max, "delta-max");
  }
  if (!request.f) {
    request.f = Interval{0, most_friction(request)};
  }
  if (constexpr double nothing = 1e-290;  // of p: its parts would be too small for a friction
      request.f->low == 0 && request.f->high < nothing * request.p.low) {
    request.f->high = 0;
  }
  require_range("f", *request.f, 0, largest_speed);
  if (!request.delta) {
    request.delta = Interval{0, most_delta(request)};
  }
  require_range("delta", *request.delta, 0, largest_square);
  if (!counts_the_notch(request) && !request.judges) {
    if (request.delta->low > 0) {
      throw InputError(
          "search-delta-m", fmt::format("{}:{}", request.delta->low, request.delta->high),
          "must include 0 unless the notch has a width (--notch-width or --search-notch-width-m) "
          "or its jumps of velocity a limit (--jump-max or --jump-max-v): without one, the "
          "acceleration in the notch is not known");
    }
    request.delta = Interval{0, 0};
  }
  if (request.width) {
    require_width(request);
  }
  for (const double p : {request.p.low, request.p.high}) {
    for (const double f : {request.f->low, request.f->high}) {
      for (const double delta : {request.delta->low, request.delta->high}) {
        require_valid(Oscillator{p, f, delta, request.hold});
        if (request.width) {
          require_valid(Oscillator{p, f, delta, request.hold}, Surface{request.width->low, {}});
          require_valid(Oscillator{p, f, delta, request.hold}, Surface{request.width->high, {}});
        }
      }
    }
  }
  return request;
}

RecordDesignRequest with_open_friction(RecordDesignRequest task) {
  task.f = task.delta = std::nullopt;
  return completed(std::move(task));
}

}  // namespace stillpoint::design
