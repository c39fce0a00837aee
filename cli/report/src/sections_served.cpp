// SPDX-License-Identifier: MIT
// What a damper serves and what practice asks of it.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

namespace stillpoint::report {

std::string interval_text(const design::ServedInterval& interval) {
  if (!interval.high) {
    constexpr int shown = 3;  // as in an interval
    return format("at least {}", limit_digits(interval.low, true, shown));
  }
  constexpr double apart = 1e-6;
  if (*interval.high - interval.low <= apart * *interval.high) {
    return "only " + digits_within(interval.low, *interval.high);
  }
  const std::string ends = interval_digits(interval.low, *interval.high);
  return begins_at_nothing(interval.low, *interval.high)
             ? "up to " + ends.substr(ends.rfind(' ') + 1)
             : ends;
}

namespace {

/// Of an interval that ends with the numbers that can be given, not where the damper fails.
std::string_view if_cut(const design::ServedInterval& served, const Interval& valid) {
  constexpr double near = 1e-9;
  const bool low = served.low > 0 && served.low <= valid.low * (1 + near);
  const bool high = served.high && *served.high >= valid.high * (1 - near);
  return low    ? "; the lower end is the program's own limit"
         : high ? "; the upper end is the program's own limit"
                : "";
}

}  // namespace

void add_works_for(Section& section, const std::optional<design::WorksFor>& served,
                   const design::Problem& problem, const Physical& physical) {
  if (!served) {
    return;
  }
  const std::string_view cut_hits = if_cut(served->v0, design::valid_v0(problem));
  const std::string_view cut_springs = if_cut(served->p, design::valid_p(problem));
  if (!physical) {
    section.row("works for", format("hits v0 of {}{}", interval_text(served->v0), cut_hits));
    section.row("", format("p of {} with v0 as given{}", interval_text(served->p), cut_springs));
    return;
  }
  const auto [velocity, period] = physical_works_for(physical->scales, *served);
  section.row("works for", format("hits of {} m/s{}", interval_text(velocity), cut_hits));
  section.row(
      "", format("periods of {} s with the hit as given{}", interval_text(period), cut_springs));
}

std::string width_shown(const Physical& physical, double width) {
  constexpr int shown = 5;
  const FigureUnits units(physical);
  return format("{}{}", limit_digits(width * units.length, true, shown),
                units.length_unit.empty() ? "" : " " + units.length_unit);
}

void add_start(Section& section, const StartUnderLoad& start, std::string_view formula,
               std::string_view go, const Physical& physical) {
  const auto& [f, delta, load] = start;
  if (delta > 0 && load > f) {
    section.row(
        "start",
        format("a notch narrower than {}, {}, does not let the mass {}: see --notch-width{}",
               width_shown(physical, delta / (load - f)), formula, go, physical ? "-m" : ""));
  }
}

void add_notch(Section& section, const std::optional<design::Practice>& lines,
               const Physical& physical) {
  if (!lines) {
    return;
  }
  if (lines->notch_used) {
    const double energy = *lines->notch_used * lines->notch_capacity;
    const auto joules = physical ? physical->scales.energy_per_passage_j(energy) : std::nullopt;
    section.row("used at the stop",
                format("{}, {:.3g} % of the notch's capacity",
                       joules ? with_unit(*joules, "J") : length_shown(physical, energy),
                       100 * *lines->notch_used));
  }
  if (lines->notch_width_min) {
    section.row("notch width",
                format("at least {} keeps the limit of the acceleration inside it too",
                       width_shown(physical, *lines->notch_width_min)));
  }
}

std::string impulse_shown(const Physical& physical, double impulse) {
  const auto newton_seconds = physical ? physical->scales.impulse_n_s(impulse) : std::nullopt;
  return newton_seconds ? with_unit(*newton_seconds, "N s")
                        : format("{} per unit mass", FigureUnits(physical).velocity_words(impulse));
}

namespace {

/// With next to no friction it has no meaning but that it is large.
std::string ratio(double value) {
  constexpr double large = 1000;
  return value < large ? format("= {:.3g}", value) : format("> {:.0f}", large);
}

}  // namespace

void add_practice(Section& section, const std::optional<design::Practice>& lines,
                  const Physical& physical) {
  if (!lines) {
    return;
  }
  section.row("base shear/weight",
              format("{:.4g}, restoring {:.4g}", lines->base_shear, lines->restoring));
  std::string secant = digits(lines->secant_stiffness);
  const auto weight = physical ? physical->scales.friction_force_n(1) : std::nullopt;
  if (weight && lines->secant_stiffness) {
    secant +=
        " = " + with_unit(*lines->secant_stiffness * *weight / physical->scales.length_m, "N/m");
  }
  section.row("secant stiffness", secant);
  section.row("equiv. damping",
              lines->equivalent_damping
                  ? format("{:.3g} % of critical, for a full cycle at this peak",
                           100 * *lines->equivalent_damping)
                  : "none: a full cycle at this peak would be damped beyond critical");
  if (lines->energy_ratio && lines->residual_ratio) {
    constexpr double asked = 0.25;  // EN 15129
    const bool enough = *lines->energy_ratio >= asked;
    section.row("re-centring",
                format("E_s/E_h {} (EN 15129{})", ratio(*lines->energy_ratio),
                       enough ? "" : " asks for 0.25"),
                enough ? Tone::plain : Tone::bad);
    section.row("", format("d/d_rm {} (EN 1998-2)", ratio(*lines->residual_ratio)));
  }
  if (lines->impulse_at_stop) {
    section.row("impulse at stop", impulse_shown(physical, *lines->impulse_at_stop));
  }
}

}  // namespace stillpoint::report
