// SPDX-License-Identifier: MIT
#include "input/record_design.hpp"

#include "input/motion.hpp"
#include "input/record_suite.hpp"
#include "input/surface.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/record_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <string_view>

namespace stillpoint::cli {

namespace {

/// What a design for a hit does not take.
constexpr std::array only_of_records{"combine",        "records-list",    "search-f",
                                     "search-delta-m", "search-period",   "hold",
                                     "record-units",   "record-step",     "record-scale",
                                     "record-peak",    "record-spectrum", "record-spectrum-period",
                                     "threads"};

/// What a design under records does not take.
constexpr std::array only_of_hits{"criterion",       "arrivals",       "tolerance-f",
                                  "tolerance-delta", "algorithm",      "k",
                                  "lambda",          "pulse-duration", "excitation-frequency"};

void require_no_others(const Settings& settings) {
  for (const std::string_view option : only_of_hits) {
    if (settings.has(option)) {
      throw UsageError(fmt::format("{} is not for a design under records", option));
    }
  }
}

/// "LOW:HIGH", each with its unit where it has one.
std::optional<design::SearchRange> search_range(const Settings& settings, std::string_view name) {
  const auto text = settings.text(name);
  if (!text) {
    return std::nullopt;
  }
  const std::size_t colon = text->find(':');
  if (colon == std::string::npos) {
    throw InputError(std::string(name), *text, "must be LOW:HIGH");
  }
  const Option& option = *find_option(name);
  const design::SearchRange range{parse_value(option, text->substr(0, colon)),
                                  parse_value(option, text->substr(colon + 1))};
  if (!(range.low >= 0 && range.low <= range.high && range.high <= largest_physical)) {
    throw InputError(
        std::string(name), *text,
        fmt::format("must be LOW:HIGH with 0 <= LOW <= HIGH <= {:.3g}", largest_physical));
  }
  return range;
}

/// With the longest period where only the range of the search is given.
MotionInput suite_motion(const Settings& settings,
                         const std::optional<design::SearchRange>& periods) {
  Settings whole = settings;
  const bool given =
      settings.has("period") || settings.has("natural-frequency") || settings.has("stiffness");
  if (periods && !given) {
    whole.set(*find_option("period"), periods->high);
  }
  return motion_input(whole, Command::design, true);
}

/// A limit in metres or in units of length; empty where not given.
std::optional<double> length_limit(const Settings& settings, const char* plain, const char* metres,
                                   const std::optional<design::PhysicalInput>& physical,
                                   double least) {
  const auto value = settings.number(metres);
  if (!value) {
    return settings.number(plain);
  }
  require_within(metres, *value, least, largest_physical);
  return *value / physical->scales.length_m;
}

design::SuiteObjective suite_objective(const Settings& settings) {
  const auto wanted = settings.text("objective");
  const auto objective = design::parse_suite_objective(wanted.value_or("acceleration"));
  if (!objective) {
    throw InputError(
        "objective", *wanted,
        fmt::format("must be {} under records", listed(design::suite_objective_names())));
  }
  return *objective;
}

/// No further than what can be manufactured.
void keep_below(std::optional<design::SearchRange>& range, const std::optional<double>& most,
                const char* field, const char* search) {
  if (!most) {
    return;
  }
  if (!(*most >= 0 && *most <= largest_speed)) {
    throw InputError(field, *most, "must be a number from 0 to 1e+150");
  }
  if (!range) {
    range = design::SearchRange{0, *most};
  } else if (range->low > *most) {
    throw UsageError(fmt::format("{} begins above {}: nothing is left to search", search, field));
  }
  range->high = std::min(range->high, *most);
}

}  // namespace

bool designs_under_records(const Settings& settings) {
  const bool records = settings.has("record") || settings.has("records-list");
  for (const std::string_view hit : {"v0", "velocity", "pulse"}) {
    if (records && settings.has(hit)) {
      throw UsageError(fmt::format("{} and records exclude each other: give one of them", hit));
    }
  }
  return records;
}

void require_no_record_options(const Settings& settings) {
  for (const std::string_view option : only_of_records) {
    if (settings.has(option)) {
      throw UsageError(
          fmt::format("{} is for a design under records: give --record as well", option));
    }
  }
}

report::RecordDesignInput record_design_input(const Settings& settings) {
  require_no_others(settings);
  const auto periods = search_range(settings, "search-period");
  const MotionInput start = suite_motion(settings, periods);
  report::RecordDesignInput input;
  input.physical = start.physical;
  design::RecordDesignRequest& request = input.request;
  const double length = start.physical ? start.physical->scales.length_m : 1;
  request.records =
      read_suite(settings,
                 start.physical ? records::RecordClock{"s", start.physical->scales.time_s, start.p}
                                : records::RecordClock{"tau", 1, start.p},
                 periods ? std::nullopt : std::optional(start.p));
  request.p = {start.p, start.p};
  if (periods) {
    require_within("search-period", periods->low, smallest_physical, largest_physical);
    const double tau = start.physical->scales.time_s;
    request.p = {2 * std::numbers::pi * tau / periods->high,
                 2 * std::numbers::pi * tau / periods->low};
  }
  request.f = search_range(settings, "search-f");
  keep_below(request.f, settings.number("f-max"), "f-max", "search-f");
  if (const auto range = search_range(settings, "search-delta-m")) {
    request.delta = design::SearchRange{range->low / length, range->high / length};
  }
  keep_below(request.delta, point_friction(settings, "delta-max", "delta-max-m", start.physical),
             "delta-max", "search-delta-m");
  request.objective = suite_objective(settings);
  if (const auto wanted = settings.known("combine")) {
    request.combine = design::parse_combine(*wanted);
  }
  request.limits.peak =
      length_limit(settings, "beta", "max-displacement", start.physical, smallest_physical);
  request.limits.residual = length_limit(settings, "residual", "residual-m", start.physical, 0);
  request.limits.acceleration = settings.number("acceleration-max");
  if (request.limits.peak && !start.physical) {
    require_within("beta", *request.limits.peak, smallest_speed, largest_speed);
  }
  if (request.limits.residual && !start.physical) {
    require_within("residual", *request.limits.residual, 0, largest_speed);
  }
  if (request.limits.acceleration) {
    require_within("acceleration-max", *request.limits.acceleration, smallest_speed, largest_speed);
  }
  request.hold = settings.number("hold").value_or(std::numeric_limits<double>::infinity());
  request.notch_width = notch_width(settings, start.physical);
  request.tolerance = settings.number("tolerance").value_or(request.tolerance);
  request.threads = static_cast<int>(settings.count("threads", 0, 0, 1024));
  return input;
}

}  // namespace stillpoint::cli
