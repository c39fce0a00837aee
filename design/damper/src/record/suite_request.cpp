// SPDX-License-Identifier: MIT
#include "record/suite_request.hpp"

#include "record/suite.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
        return (request.limits.*kind.limit).has_value();
      })) {
    throw InputError::missing("max-displacement",
                              "give a limit, of stroke, residual or acceleration, that bounds the "
                              "tolerance");
  }
}

/// Whether a friction at a passage counts in what is asked.
bool asks_for_acceleration(const RecordDesignRequest& request) {
  return request.objective == SuiteObjective::acceleration || request.limits.acceleration;
}

}  // namespace

bool counts_the_notch(const RecordDesignRequest& request) {
  return !asks_for_acceleration(request) || request.width || request.limits.jump;
}

void require_valid(const RecordDesignRequest& request) {
  design::require_valid(request.records);
  require_range("p", request.p, smallest_speed, largest_speed);
  require_limit("beta", request.limits.peak, smallest_speed);
  require_limit("acceleration-max", request.limits.acceleration, smallest_speed);
  require_limit("residual", request.limits.residual, 0);
  require_limit("jump-max", request.limits.jump, 0);
  require_spread("tolerance-f", request.tolerance.f);
  require_spread("tolerance-delta", request.tolerance.delta);
  require_spread("tolerance-width", request.tolerance.width);
  require_spread("tolerance-period", request.tolerance.period);
  if (request.objective == SuiteObjective::robust) {
    require_growth(request);
  }
  if (request.width) {
    require_range("notch-width", *request.width, 1e-150, 1e150);
    if (request.limits.jump) {
      throw InputError("jump-max", *request.limits.jump,
                       "is for a notch without a width, which has no jumps");
    }
  }
  require_within("scan_points", static_cast<double>(request.scan_points), 1, 1e8);
}

RecordDesignRequest completed(RecordDesignRequest request) {
  request.combine = request.combine.value_or(default_combine(request.records.size()));
  keep_below(request.f, request.f_max, "f-max");
  keep_below(request.delta, request.delta_max, "delta-max");
  request.f = request.f.value_or(Interval{0, peak_load(request.records)});
  require_range("f", *request.f, 0, largest_speed);
  if (!request.delta) {
    double peak = request.limits.peak.value_or(0);
    for (const SuiteRecord& record : request.records) {
      if (!request.limits.peak) {
        const Excitation load = record.record;
        const ForcedResponse free =
            forced_response({request.p.low, 0, 0}, {}, load, {.t_end = duration(load)});
        peak = std::max(peak, std::abs(record.scale) * free.peak_amplitude);
      }
    }
    const double speed = request.p.high * peak;
    request.delta = Interval{0, speed * speed / 2 + peak_load(request.records) * peak};
  }
  require_range("delta", *request.delta, 0, largest_square);
  if (!counts_the_notch(request)) {
    if (request.delta->low > 0) {
      throw InputError(
          "search-delta-m", fmt::format("{}:{}", request.delta->low, request.delta->high),
          "must include 0 unless the notch has a width (--notch-width or --search-notch-width-m) "
          "or its jumps of velocity a limit (--jump-max or --jump-max-v): without one, the "
          "acceleration in the notch is not known");
    }
    request.delta = Interval{0, 0};
  }
  if (request.objective == SuiteObjective::residual) {
    request.limits.late = latest_rest;
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

}  // namespace stillpoint::design
