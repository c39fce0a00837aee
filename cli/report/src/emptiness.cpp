// SPDX-License-Identifier: MIT
// What a report says where no damper is admissible.
#include "sections.hpp"

namespace stillpoint::report {

namespace {

/// An input as it can be given, and the values that admit a damper.
struct Way {
  std::string name;    ///< "max displacement"
  std::string values;  ///< "at least 168.79 mm", rounded to the safe side
};

/// "lowest period" of "period" for an end of a range, whose field says which.
std::string of_range(std::string_view field, std::string_view name, bool turned) {
  const bool low = field.ends_with("_low");
  const std::string_view end = !(low || field.ends_with("_high")) ? ""
                               : low != turned                    ? "lowest "
                                                                  : "highest ";
  name = name.substr(0, name.find(low ? "_low" : "_high"));
  return format("{}{}", end,
                in_words(name.substr(0, name.size() - (name.ends_with("_m") ? 2 : 0))));
}

Way way_of(const design::Mend& mend, const Physical& physical, const design::Limits& limits,
           const std::optional<design::Pulse>& pulse) {
  constexpr int shown = 5;
  if (mend.field == "tolerance") {
    return {"tolerance", "at most " + tolerance_text(limits, mend.value)};
  }
  if (mend.field == "arrivals") {
    return {"number of arrivals", format("at least {}", mend.value)};
  }
  const bool of_load = mend.field.starts_with("k") || mend.field == "acceleration_max";
  design::PhysicalMend now{mend.field, of_load ? "g" : "", mend.value, mend.upwards};
  if (physical) {
    now = physical_mend(*physical, mend, pulse).value_or(now);
  }
  const Unit unit = now.unit == "m"
                        ? Unit{units_of(physical).length.factor / physical->scales.length_m,
                               units_of(physical).length.name}
                        : read_in(physical, now.unit, now.value);
  // The longest period is that of the softest spring, the least p.
  return {of_range(mend.field, now.name, now.upwards != mend.upwards),
          format("at {} {}{}", now.upwards ? "least" : "most",
                 limit_digits(now.value * unit, now.upwards, shown), with_blank(unit.name))};
}

/// In the units of the task; a catalogue that misses the region has a reason of its own.
std::string reason_in_units(const design::RegionVerdict& empty, const ShownTask& task) {
  const FigureUnits units = units_of(task.physical);
  return task.pulse || empty.region.conflict == design::Conflict::none
             ? empty.reason.value()
             : design::reason(empty.region, task.problem, task.limits,
                              {units.length.factor, units.length.name, units.velocity.factor,
                               units.velocity.name})
                   .value();
}

/// What the verdict does not say by itself.
std::string way_out(const design::RegionVerdict& empty, const ShownTask& task) {
  return !empty.mends.empty() && !(empty.most_tolerant && empty.mends.front().field == "tolerance")
             ? one_way_out(empty.mends, task.physical, task.limits, task.pulse)
         : empty.mends.empty() && empty.criterion_mend ? " One way out: the exact criterion."
                                                       : "";
}

}  // namespace

std::string one_way_out(std::span<const design::Mend> mends, const Physical& physical,
                        const design::Limits& limits, const std::optional<design::Pulse>& pulse) {
  if (mends.empty()) {
    return "";
  }
  // As the names of v0, p, k, lambda and their ends begin.
  static constexpr std::string_view given = "vpkl";
  const auto chosen = std::ranges::find_if(mends, [](const design::Mend& mend) {
    return given.find(mend.field.front()) == std::string_view::npos;
  });
  const design::Mend& mend = chosen != mends.end() ? *chosen : mends.front();
  const auto [name, values] = way_of(mend, physical, limits, pulse);
  return format(" One way out: a {} of {}{}.", name, values,
                mend.in_case.empty() ? "" : " in case " + mend.in_case);
}

std::string none_admissible(const design::RegionVerdict& empty, const ShownTask& task) {
  constexpr int as_asked = 7;  // digits
  const auto& most = empty.most_tolerant;
  return format("No admissible design: {}.{}",
                most ? format("no damper has a tolerance of {}; the best has {}, at f = {:.6g}, "
                              "delta = {}",
                              tolerance_text(task.limits, task.limits.tolerance, as_asked),
                              tolerance_text(task.limits, most->tolerance), most->f,
                              length_shown(task.physical, most->delta))
                     : reason_in_units(empty, task),
                way_out(empty, task));
}

Section& add_mends(Document& document, std::span<const design::Mend> mends,
                   const Physical& physical, const design::Limits& limits,
                   const std::optional<design::Pulse>& pulse) {
  Section& section = document.section("What would make it feasible, each alone");
  for (const design::Mend& mend : mends) {
    auto [name, values] = way_of(mend, physical, limits, pulse);
    section.row(mend.in_case.empty() ? std::move(name) : format("{}: {}", mend.in_case, name),
                std::move(values));
  }
  return section;
}

void add_mends(Document& document, const design::RegionVerdict& empty, const ShownTask& task) {
  Section& section = add_mends(document, empty.mends, task.physical, task.limits, task.pulse);
  if (empty.criterion_mend) {
    section.row("criterion", "exact: the published one requires more delta than needed");
  }
  if (section.parts.empty()) {
    section.line("No change of a single input was found that would.");
    if (empty.largest_tolerance) {
      section.row("tolerance", format("no damper has more than {}, whatever the limits",
                                      percent_digits(*empty.largest_tolerance)));
    }
  }
}

}  // namespace stillpoint::report
