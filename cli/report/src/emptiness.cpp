// SPDX-License-Identifier: MIT
// What a report says where no damper is admissible.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>

namespace stillpoint::report {

namespace {

/// An input as it can be given, and the value that admits a damper: "max displacement", "168.79
/// mm".
struct Way {
  std::string name;
  std::string bound;  ///< rounded to the safe side
  bool upwards;       ///< at least that
};

/// "lowest period" of "period" for an end of a range, whose field says which.
std::string of_range(std::string_view field, std::string_view name, bool turned) {
  name.remove_suffix(name.ends_with("_m") ? 2 : 0);
  const bool low = field.ends_with("_low");
  const std::string_view end = !(low || field.ends_with("_high")) ? ""
                               : low != turned                    ? "lowest "
                                                                  : "highest ";
  return format("{}{}", end, in_words(name.substr(0, name.find(low ? "_low" : "_high"))));
}

Way way_of(const design::Mend& mend, const Physical& physical, const design::Limits& limits,
           const std::optional<design::Pulse>& pulse) {
  constexpr int shown = 5;
  if (mend.field == "tolerance") {
    return {"tolerance", tolerance_text(limits, mend.value), false};
  }
  const auto now = physical ? physical_mend(*physical, mend, pulse) : std::nullopt;
  if (!now) {
    std::string_view unit = mend.field.starts_with("k") ? " g" : "";
    for (const design::LimitKind& kind : design::limit_kinds()) {
      unit = kind.field == mend.field ? kind.unit : unit;
    }
    return {of_range(mend.field, mend.field, false),
            format("{}{}", limit_digits(mend.value, mend.upwards, shown), unit), mend.upwards};
  }
  // The longest period is that of the softest spring, the least p.
  const FigureUnits units = units_of(physical);
  const bool length = now->unit == "m";
  const double unit = length ? units.length.factor / physical->scales.length_m : 1;
  return {of_range(mend.field, now->name, now->upwards != mend.upwards),
          format("{} {}", limit_digits(now->value * unit, now->upwards, shown),
                 length ? units.length.name : now->unit),
          now->upwards};
}

/// "a max displacement of at least 168.8 mm", "a limit of at least 0.05 on f", "at least 2
/// arrivals".
std::string words_of(const Way& way) {
  constexpr std::string_view largest = "largest ";
  return way.name == "arrivals" ? format("at least {} arrivals", way.bound)
         : way.name.starts_with(largest)
             ? format("a limit of at least {} on {}", way.bound, way.name.substr(largest.size()))
             : format("a {} of at {} {}", way.name, way.upwards ? "least" : "most", way.bound);
}

/// Of several mends the first of what a designer can choose: that of beta, which is the stroke, if
/// there is one. Nobody chooses the hit, and the period only by another isolator.
const design::Mend& named_mend(const std::vector<design::Mend>& mends) {
  // As the names of v0, p, k, lambda and their ends begin.
  static constexpr std::string_view given = "vpkl";
  const auto chosen = std::ranges::find_if(mends, [](const design::Mend& mend) {
    return given.find(mend.field.front()) == std::string_view::npos;
  });
  return chosen != mends.end() ? *chosen : mends.front();
}

/// "no damper has a tolerance of 40 %; the best has a tolerance of 22.22 %, at f = 0.275, delta =
/// 0.4"
std::string most_tolerant_text(const design::DesignPoint& most, const design::Limits& limits,
                               const Physical& physical) {
  constexpr int many = 8;  // if the usual digits do not distinguish them
  const bool alike =
      tolerance_text(limits, most.tolerance) == tolerance_text(limits, limits.tolerance);
  const int shown = alike ? many : usual_digits;
  return format("no damper has a tolerance of {}; the best has {}, at f = {:.6g}, delta = {}",
                tolerance_text(limits, limits.tolerance, shown),
                tolerance_text(limits, most.tolerance, shown), most.f,
                length_shown(physical, most.delta));
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

/// " One way out: a max displacement of at least 168.8 mm."
std::string way_out(const design::RegionVerdict& empty, const ShownTask& task) {
  if (empty.mends.empty()) {
    return empty.criterion_mend ? " One way out: the exact criterion." : "";
  }
  const design::Mend& mend = named_mend(empty.mends);
  return empty.most_tolerant && mend.field == "tolerance"
             ? ""  // which the verdict says
             : format(" One way out: {}.",
                      words_of(way_of(mend, task.physical, task.limits, task.pulse)));
}

}  // namespace

std::string none_admissible(const design::RegionVerdict& empty, const ShownTask& task) {
  return format("No admissible design: {}.{}",
                empty.most_tolerant
                    ? most_tolerant_text(*empty.most_tolerant, task.limits, task.physical)
                    : reason_in_units(empty, task),
                way_out(empty, task));
}

Section& add_mends(Document& document, std::span<const design::Mend> mends,
                   const Physical& physical, const design::Limits& limits,
                   const std::optional<design::Pulse>& pulse) {
  Section& section = document.section("What would make it feasible, each alone");
  for (const design::Mend& mend : mends) {
    const Way way = way_of(mend, physical, limits, pulse);
    section.row(way.name, format("at {} {}", way.upwards ? "least" : "most", way.bound));
  }
  return section;
}

void add_mends(Document& document, const design::RegionVerdict& empty, const ShownTask& task) {
  Section& section = add_mends(document, empty.mends, task.physical, task.limits, task.pulse);
  if (empty.criterion_mend) {
    section.row("criterion", "exact: the published one requires more delta than needed");
  }
  if (section.parts.empty()) {
    section.line("No change of a single input was found.");
    if (empty.largest_tolerance) {
      section.row("tolerance", format("at most {} for any damper, whatever the limits",
                                      percent_digits(*empty.largest_tolerance)));
    }
  }
}

std::string mend_title(const design::RegionVerdict& empty, const ShownTask& task,
                       std::string_view what) {
  if (empty.mends.empty()) {
    return format("No {} is admissible", what);
  }
  const auto& [name, bound, upwards] =
      way_of(named_mend(empty.mends), task.physical, task.limits, task.pulse);
  return name == "arrivals"
             ? format("No {} with fewer than {} arrivals", what, bound)
             : format("No {} with a {} {} {}", what, name, upwards ? "below" : "above", bound);
}

}  // namespace stillpoint::report
