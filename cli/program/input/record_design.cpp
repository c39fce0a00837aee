// SPDX-License-Identifier: MIT
#include "input/request.hpp"

#include "input/motion.hpp"
#include "input/record.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/record_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace stillpoint::cli {

namespace {

/// A single value is a range of its own.
std::optional<Interval> search_range(const Settings& settings, const char* name) {
  const auto high = settings.number(name);
  if (!high) {
    return std::nullopt;
  }
  const double low = settings.range(name).value_or(Interval{*high, *high}).low;
  records::require_physical(name, find_option(name)->traits.dimension, *high, std::max(low, 0.0));
  return Interval{low, *high};
}

/// With the longest period if only the range of the search is given.
MotionInput suite_motion(const Settings& settings, const std::optional<Interval>& periods) {
  Settings whole = settings;
  const Option* const spring = settings.given(Rivals::stiffness);
  if (periods && spring == nullptr) {
    whole.set("period", periods->high);
  }
  MotionInput motion = motion_input(whole, Command::design, true);
  if (motion.p_high) {
    const auto [low, high] = settings.range(spring->name).value();
    throw InputError(std::string(spring->name), fmt::format("{}:{}", low, high),
                     "must be one number with records; --search-period searches a range");
  }
  return motion;
}

design::SuiteTolerance tolerances(const Settings& settings) {
  design::SuiteTolerance of;
  if (const auto all = spread(settings, "tolerance")) {
    of.f = of.delta = of.width = *all;
  }
  of.f = spread(settings, "tolerance-f").value_or(of.f);
  of.delta = spread(settings, "tolerance-delta").value_or(of.delta);
  of.width = spread(settings, "tolerance-width").value_or(of.width);
  of.period = spread(settings, "tolerance-period").value_or(of.period);
  return of;
}

std::optional<double> jump_limit(const Settings& settings, const Physical& physical) {
  const auto limit = settings.number("jump-max");
  return limit ? std::optional(*limit / physical->scales.velocity_m_per_s)
               : settings.number("jump-max-v");
}

}  // namespace

bool designs_under_records(const Settings& settings) {
  const bool records = asks_for_records(settings);
  if (const Option* const hit = settings.given(Rivals::hit); records && hit != nullptr) {
    throw UsageError(fmt::format("{} and records cannot be combined: give one of them", hit->name));
  }
  return records;
}

void require_options_for(const Settings& settings, DesignFor design) {
  const Option* const wrong = settings.first([&](const Option& option) {
    return option.design_for() != DesignFor::both && option.design_for() != design;
  });
  if (wrong != nullptr) {
    throw UsageError(fmt::format("{} {}", wrong->name,
                                 design == DesignFor::records
                                     ? "cannot be used in a design under records"
                                     : "needs a design under records: give --record as well"));
  }
}

report::RecordDesignInput record_design_input(const Settings& settings) {
  require_options_for(settings, DesignFor::records);
  const auto periods = search_range(settings, "search-period");
  const MotionInput start = suite_motion(settings, periods);
  report::RecordDesignInput input;
  input.physical = start.physical;
  design::RecordDesignRequest& request = input.request;
  const double length = start.physical ? start.physical->scales.length_m : 1;
  request.records = read_suite(settings, record_clock(start.physical, start.p),
                               periods ? std::nullopt : std::optional(start.p));
  request.p = {start.p, start.p};
  if (periods) {
    records::require_physical("search-period", Dimension::time, periods->low);
    const design::Scales& scales = start.physical->scales;
    request.p = {scales.p_of(periods->high), scales.p_of(periods->low)};
  }
  request.f = search_range(settings, "search-f");
  request.f_max = settings.number("f-max");
  if (const auto range = search_range(settings, "search-delta-m")) {
    request.delta = Interval{range->low / length, range->high / length};
  }
  request.delta_max = point_friction(settings, "delta-max", start.physical);
  request.objective = objective_of(settings, request.objective, " under records");
  request.combine = settings.named<design::Combine>("combine");
  request.limits = {in_either(settings, "beta", length, smallest_physical),
                    settings.number("acceleration-max"),
                    in_either(settings, "residual", length, 0),
                    jump_limit(settings, start.physical),
                    {}};
  request.hold = settings.number("hold");
  if (const auto width = notch_width(settings, start.physical)) {
    request.width = Interval{*width, *width};
  }
  if (const auto widths = search_range(settings, "search-notch-width-m")) {
    request.width = Interval{widths->low / length, widths->high / length};
  }
  request.tolerance = tolerances(settings);
  request.scan_points = settings.integer("scan-points").value_or(request.scan_points);
  request.threads = threads(settings);
  request.printed = {length,
                     start.physical ? std::optional(start.physical->scales.time_s) : std::nullopt};
  return input;
}

}  // namespace stillpoint::cli
