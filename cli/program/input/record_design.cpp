// SPDX-License-Identifier: MIT
#include "input/request.hpp"

#include "input/cases.hpp"
#include "input/record.hpp"

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

/// With the longest period if only the range of the search is given, and in the units of the first
/// hit.
MotionInput suite_motion(const Settings& settings, const std::vector<GivenCase>& cases,
                         const std::optional<Interval>& periods, Command command) {
  Settings whole = settings;
  for (const GivenCase& each : cases) {
    if (const auto velocity = each.settings.number("velocity");
        velocity && !whole.has("velocity")) {
      whole.set("velocity", *velocity);
    }
  }
  const Option* const spring = settings.given(Rivals::stiffness);
  if (periods && spring == nullptr) {
    whole.set("period", periods->high);
  }
  MotionInput motion = motion_input(whole, command, true);
  if (motion.p_high && periods) {
    throw UsageError(
        fmt::format("search-period and a range of {} cannot be combined: what is "
                    "searched does not vary",
                    spring->name));
  }
  return motion;
}

/// Without any that is asked for there is one only under records, and where it is enlarged; of the
/// width only under records.
design::SuiteTolerance tolerances(const Settings& settings,
                                  const design::RecordDesignRequest& request) {
  const bool grows = !request.judges && !request.maps && request.parts.empty() &&
                     request.objective == design::SuiteObjective::robust;
  const bool of_records = std::ranges::any_of(request.cases, &design::LoadCase::of_records);
  const bool usual = grows || of_records;
  design::SuiteTolerance of =
      usual ? design::SuiteTolerance() : design::SuiteTolerance{{}, {}, {}, {}};
  if (const auto all = spread(settings, "tolerance")) {
    of.f = of.delta = of.width = *all;
  }
  of.width = of_records ? of.width : design::Spread();
  of.f = spread(settings, "tolerance-f").value_or(of.f);
  of.delta = spread(settings, "tolerance-delta").value_or(of.delta);
  of.width = spread(settings, "tolerance-width").value_or(of.width);
  of.period = spread(settings, "tolerance-period").value_or(of.period);
  return of;
}

Interval damping_of(const Settings& settings, const Oscillator& mass) {
  return settings.range("damping").value_or(Interval{mass.zeta, mass.zeta});
}

/// What makes the mass another than that of the closed forms; empty: nothing.
std::string_view beyond_closed_forms(const Settings& settings) {
  const Oscillator mass = mass_input(settings, 1);
  return !mass.coulomb() && mass.zeta == 0                         ? "breakaway"
         : !mass.coulomb() || damping_of(settings, mass).high != 0 ? "damping"
                                                                   : "";
}

}  // namespace

bool takes_cases(const Settings& settings) {
  if (settings.has("cases")) {
    return true;
  }
  const Option* const hit = settings.given(Rivals::hit);
  if (asks_for_records(settings)) {
    if (hit != nullptr) {
      throw UsageError(
          fmt::format("{} and records cannot be combined: give one of them", hit->name));
    }
    return true;
  }
  const bool beyond = !beyond_closed_forms(settings).empty();
  return hit != nullptr && (beyond || settings.first([&](const Option& option) {
           return option.design_for() == DesignFor::cases ||
                  (option.name == "objective" && settings.text("objective") == "residual") ||
                  (hit->name == "pulse" &&
                   (option.traits.rivals == Rivals::residual ||
                    (option.name == "arrivals" && settings.integer("arrivals") > 1) ||
                    option.name == "trade-off"));
         }) != nullptr);
}

std::string published_beyond(std::string_view beyond) {
  return fmt::format(
      "criterion published and {} cannot be combined: the paper's Delta1 has no meaning with it",
      beyond);
}

void require_options_for(const Settings& settings, DesignFor design) {
  const std::string_view beyond = beyond_closed_forms(settings);
  if (design == DesignFor::hit && !beyond.empty()) {
    throw UsageError(fmt::format("{} cannot be used here: closed forms do not know it", beyond));
  }
  if (!beyond.empty() &&
      settings.named<design::Criterion>("criterion") == design::Criterion::published) {
    throw UsageError(published_beyond(beyond));
  }
  const bool has_cases = settings.has("cases");
  const bool of_records = design == DesignFor::records && (has_cases || asks_for_records(settings));
  const bool of_a_hit_beyond = !beyond.empty() && !of_records;
  const Option* const wrong = settings.first([&](const Option& option) {
    const DesignFor only = option.design_for();
    return only != DesignFor::both && only != design && only != DesignFor::cases &&
           !(option.name == "criterion" && of_a_hit_beyond) &&  // its motion is the exact one
           !(option.is_of_case() && (has_cases || (design == DesignFor::records && !of_records)));
  });
  if (wrong != nullptr) {
    throw UsageError(
        fmt::format("{} {}", wrong->name,
                    design != DesignFor::records ? "needs records: give --record as well"
                    : of_records                 ? "cannot be used under records"
                                 : "is for the closed forms of a hit or a pulse, and with the "
                                   "other options given motions are simulated: leave it out"));
  }
}

/// The damper, or the parts of a catalogue, that are to be judged.
void add_given(design::RecordDesignRequest& request, const Settings& settings,
               const MotionInput& start, Command command) {
  if (settings.has("catalogue")) {
    if (request.trade_offs > 0) {
      throw UsageError(
          "trade-off and catalogue cannot be combined: the parts are what is searched");
    }
    if (command == Command::region && settings.has("f")) {
      throw UsageError("catalogue and f cannot be combined: give the parts or one damper");
    }
    request.parts = catalogue_input(settings, units_of_parts(request.p.high, start.physical));
  } else if (command == Command::region) {
    const auto f = settings.number("f");
    const auto delta = point_friction(settings, "delta", start.physical);
    const bool alone = !settings.has("cases") && !asks_for_records(settings);
    request.maps = alone && !delta;
    if (!request.maps && (!f || !delta)) {
      throw InputError::missing(
          f ? "delta" : "f",
          alone ? "delta alone is not a damper: give f as well"
                : "give a damper to judge, --f and --delta or --delta-m, or a --catalogue: the "
                  "region itself is for a hit or a pulse");
    }
    if (f) {
      request.f = Interval{*f, *f};
    }
    if (delta) {
      request.delta = Interval{*delta, *delta};
    }
    request.judges = !request.maps;
  }
}

report::RecordDesignInput record_design_input(const Settings& given, Command command) {
  const Settings settings = given.over_weight();
  require_options_for(settings, DesignFor::records);
  const auto periods = search_range(settings, "search-period");
  const std::vector<GivenCase> cases = cases_of(settings);
  const MotionInput start = suite_motion(settings, cases, periods, command);
  report::RecordDesignInput input;
  input.physical = start.physical;
  design::RecordDesignRequest& request = input.request;
  const double length = start.physical ? start.physical->scales.length_m : 1;
  request.p = {start.p, start.p};
  if (periods) {
    records::require_physical("search-period", Dimension::time, periods->low);
    const design::Scales& scales = start.physical->scales;
    request.p = {scales.p_of(periods->high), scales.p_of(periods->low)};
  }
  if (start.p_high) {
    request.spring = {1 - start.p / *start.p_high, 0};
  }
  for (const GivenCase& each : cases) {
    request.cases.push_back(load_case(each, start, !periods && !start.p_high));
  }
  request.f = search_range(settings, "search-f");
  request.f_max = settings.number("f-max");
  if (const auto range = search_range(settings, "search-delta-m")) {
    request.delta = Interval{range->low / length, range->high / length};
  }
  request.delta_max = point_friction(settings, "delta-max", start.physical);
  request.objective = objective_of(settings, usual_objective(request.cases),
                                   settings.has("cases")        ? " with cases"
                                   : asks_for_records(settings) ? " under records"
                                                                : "");
  request.objective_case = objective_case(settings, request.cases);
  const Oscillator mass = mass_input(settings, start.p);
  request.hold = mass.hold;
  request.zeta = damping_of(settings, mass);
  request.breakaway = mass.breakaway;
  if (const auto width = notch_width(settings, start.physical)) {
    request.width = Interval{*width, *width};
  }
  if (const auto widths = search_range(settings, "search-notch-width-m");
      widths && command == Command::design) {
    request.width = Interval{widths->low / length, widths->high / length};
  }
  if (!request.width && settings.has("tolerance-width") && !asks_for_records(settings)) {
    throw UsageError("tolerance-width needs a notch with a width: give --notch-width-m as well");
  }
  request.trade_offs = settings.integer("trade-off").value_or(0);
  add_given(request, settings, start, command);
  request.tolerance = tolerances(settings, request);
  request.requires_tolerance = settings.first([](const Option& option) {
    return option.name.starts_with("tolerance");
  }) != nullptr;
  input.parts_file = settings.text("catalogue").value_or("");
  input.of_region = command == Command::region;
  request.scan_points = settings.integer("scan-points").value_or(request.scan_points);
  request.threads = threads(settings);
  request.printed = {length,
                     start.physical ? std::optional(start.physical->scales.time_s) : std::nullopt};
  return input;
}

}  // namespace stillpoint::cli
