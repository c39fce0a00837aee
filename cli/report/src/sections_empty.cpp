// SPDX-License-Identifier: MIT
// What a report says where no damper is admissible.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace stillpoint::report {

namespace {

/// An input as it can be given, with the value that admits a damper.
struct ShownMend {
  std::string name;
  double value;
  bool upwards;
  std::string unit;  ///< after a blank; that of the figures for lengths

  /// "at least 168.79 mm", rounded to the safe side.
  [[nodiscard]] std::string bound() const {
    constexpr int shown = 5;
    return format("at {} {}{}", upwards ? "least" : "most", limit_digits(value, upwards, shown),
                  unit);
  }
};

ShownMend dimensionless(const design::Mend& mend) {
  std::string_view unit = mend.field.starts_with("k") ? " g" : "";
  for (const design::LimitKind& kind : design::limit_kinds()) {
    unit = kind.field == mend.field ? kind.unit : unit;
  }
  return {std::string(mend.field), mend.value, mend.upwards, std::string(unit)};
}

std::optional<ShownMend> with_units(const design::Mend& mend, const EmptyTask& task) {
  const auto now = task.physical ? physical_mend(*task.physical, mend, task.pulse) : std::nullopt;
  if (!now) {
    return std::nullopt;
  }
  // The longest period is that of the softest spring, the least p.
  const bool turned = now->upwards != mend.upwards;
  const bool low = mend.field.ends_with("_low");
  const std::string_view end = !(low || mend.field.ends_with("_high")) ? ""
                               : low != turned                         ? "lowest "
                                                                       : "highest ";
  ShownMend shown{format("{}{}", end, now->name), now->value, now->upwards,
                  format(" {}", now->unit)};
  if (now->unit == "m") {
    const FigureUnits units(task.physical);
    shown.value *= units.length / task.physical->scales.length_m;
    shown.unit = " " + units.length_unit;
  }
  return shown;
}

/// The option that gives the tolerance.
std::string_view name_of_tolerance(const design::BoxShape& shape) {
  return std::max(shape.delta_low, shape.delta_high) == 0 ? "tolerance_f"
         : std::max(shape.f_low, shape.f_high) == 0       ? "tolerance_delta"
                                                          : "tolerance";
}

/// "max displacement must be at least 168.8 mm", "tolerance must be at most 34.18 %".
std::string words_of(const design::Mend& mend, const EmptyTask& task) {
  if (mend.field == "tolerance") {
    return "tolerance must be at most " + (task.limits.shape == design::BoxShape{}
                                               ? percent_digits(mend.value)
                                               : box_text(task.limits, mend.value));
  }
  const ShownMend shown = with_units(mend, task).value_or(dimensionless(mend));
  const std::string name = in_words(shown.name);
  return format("{}{} must be {}", name.starts_with("largest") ? "the " : "", name, shown.bound());
}

/// Nobody chooses the hit, and the period only by another isolator.
bool is_given(const design::Mend& mend) {
  const std::string_view field = mend.field;
  return field.starts_with("v0") || field.starts_with("p") || field.starts_with("k") ||
         field.starts_with("lambda");
}

/// Of several mends that of beta, which is the stroke, or else of what a designer can choose.
const design::Mend& named_mend(const std::vector<design::Mend>& mends) {
  const auto of_beta = std::ranges::find(mends, "beta", &design::Mend::field);
  const auto chosen = std::ranges::find(mends, false, is_given);
  return of_beta != mends.end() ? *of_beta : chosen != mends.end() ? *chosen : mends.front();
}

constexpr std::string_view exact_words = "criterion must be exact";

void add_mend(Section& section, const design::Mend& mend, const EmptyTask& task) {
  if (mend.field == "tolerance") {
    section.row(in_words(name_of_tolerance(task.limits.shape)),
                "at most " + box_text(task.limits, mend.value));
    return;
  }
  const ShownMend plain = dimensionless(mend);
  if (const auto now = with_units(mend, task)) {
    section.row(in_words(now->name),
                format("{}   ({} {})", now->bound(), plain.name, plain.bound()));
  } else {
    section.row(in_words(plain.name), plain.bound());
  }
}

/// " No damper has a tolerance of 40 %; the largest is 22.22 %, at f = 0.275, delta = 0.4."
std::string most_tolerant_text(const design::DesignPoint& most, const design::Limits& limits,
                               const Physical& physical) {
  constexpr int many = 8;  // if the usual digits do not distinguish them
  const bool alike =
      tolerance_shown(limits, most.tolerance) == tolerance_shown(limits, limits.tolerance);
  const int shown = alike ? many : usual_digits;
  return format(" No damper has {}; the best has {}, at f = {:.6g}, delta = {}.",
                tolerance_shown(limits, limits.tolerance, shown),
                tolerance_shown(limits, most.tolerance, shown), most.f,
                length_text(physical, most.delta));
}

/// The reason that no f meets a limit under a pulse, with the limit on the peak as a length.
std::string pulse_reason(const design::RegionVerdict& empty, const EmptyTask& task) {
  const design::Region& region = empty.region;
  const FigureUnits units(task.physical);
  const std::string allowed = units.length_words(task.problem.beta);
  if (region.conflict == design::Conflict::amplitude_against_return &&
      region.beta_min > task.problem.beta) {
    return format(
        "amplitude and return conflict: coming back to x = 0 needs f <= {:.6g}, and then the peak "
        "is at least {}, where {} is allowed",
        region.f3, units.length_words(region.beta_min), allowed);
  }
  constexpr std::string_view within_beta = "within beta";
  std::string text = empty.reason.value();
  if (const std::size_t at = text.find(within_beta); at != std::string::npos) {
    text.replace(at, within_beta.size(), "within " + allowed);
  }
  return text;
}

/// The reason in the units of the task. A catalogue that misses the region has one without numbers
/// that have a unit.
std::string reason_in_units(const design::RegionVerdict& empty, const EmptyTask& task) {
  if (!task.physical || empty.region.conflict == design::Conflict::none) {
    return empty.reason.value();
  }
  if (task.pulse) {
    return pulse_reason(empty, task);
  }
  const FigureUnits units(task.physical);
  return design::reason(empty.region, task.problem, task.limits,
                        {units.length, units.length_unit, units.velocity, units.velocity_unit})
      .value();
}

}  // namespace

void add_emptiness(Document& document, const design::RegionVerdict& empty, const EmptyTask& task) {
  const auto& mends = empty.mends;
  const bool exact = empty.criterion_mend.has_value();
  const auto joint = exact ? std::nullopt : empty.joint_mend;
  document.verdict = empty.most_tolerant
                         ? "No admissible design." +
                               most_tolerant_text(*empty.most_tolerant, task.limits, task.physical)
                         : format("No admissible design: {}.", reason_in_units(empty, task));
  document.tone = Tone::bad;
  Section& section = document.section("What would make it feasible");
  if (joint) {
    section.line(format(
        "No single change makes it feasible: whatever beta and the limits are, no damper has more "
        "than a tolerance of {}, and without a tolerance there is none either. Both of these "
        "changes together make it feasible:",
        box_text(task.limits, joint->largest_tolerance)));
  } else if (mends.empty() && !exact) {
    section.line("No change of a single input makes it feasible.");
  } else {
    section.line(
        mends.size() + (exact ? 1 : 0) == 1
            ? "This change makes it feasible; the value is the nearest that does:"
            : "Changing any one of these makes it feasible; each value is the nearest that does:");
  }
  for (const design::Mend& mend : joint ? joint->mends : mends) {
    add_mend(section, mend, task);
  }
  if (exact) {
    section.row("criterion", "exact: its Delta1 is sharp, the published one is larger");
  }
}

std::string mend_title(const design::RegionVerdict& empty, const EmptyTask& task,
                       std::string_view what) {
  if (!empty.mends.empty()) {
    return format("No {}: {}", what, words_of(named_mend(empty.mends), task));
  }
  return empty.criterion_mend ? format("No {}: {}", what, exact_words)
                              : format("No {} is admissible", what);
}

std::string what_would_help(const design::RegionVerdict& empty, const EmptyTask& task) {
  std::string all;
  if (empty.most_tolerant && !empty.mends.empty() && named_mend(empty.mends).field == "tolerance") {
    return all;  // which the verdict says
  }
  if (!empty.mends.empty()) {
    all = words_of(named_mend(empty.mends), task);
  } else if (empty.criterion_mend) {
    all = exact_words;
  } else if (empty.joint_mend) {
    for (const design::Mend& mend : empty.joint_mend->mends) {
      all += (all.empty() ? "" : " and ") + words_of(mend, task);
    }
  }
  return all.empty() ? all
                     : format(" {} {}.",
                              empty.mends.size() > 1 ? "One way to get one:" : "To get one,", all);
}

}  // namespace stillpoint::report
