// SPDX-License-Identifier: MIT
// What a damper works for, and the figures used in practice.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::report {

std::string interval_text(const design::ServedInterval& interval, const Interval& asked) {
  const double low = end_or_asked(interval.low, asked.low);
  if (!interval.high) {
    constexpr int shown = 3;  // as in an interval
    return format("at least {}", limit_digits(low, true, shown));
  }
  const double high = end_or_asked(*interval.high, asked.high);
  constexpr double apart = 1e-6;
  if (high - low <= apart * high) {
    return format("exactly {}", decimal_within(low, high));
  }
  return interval_digits(low, high);
}

Interval asked_hits(const design::Problem& problem) {
  return {problem.v0_low.value_or(problem.v0), problem.v0};
}

namespace {

/// Which ends are the program's own limit, not the damper's: of what is valid, not where that
/// begins at next to nothing; `turned` if one value falls with the other, as a period with p.
struct OwnEnds {
  OwnEnds(const design::ServedInterval& served, const Interval& valid, bool turned,
          bool of_search = false) {
    constexpr double rounding = 1e-12;
    const bool nothing = !of_search && served.high && begins_at_nothing(served.low, *served.high);
    (turned ? high : low) = served.low <= valid.low * (1 + rounding) && served.low > 0 && !nothing;
    (turned ? low : high) = served.high && *served.high >= valid.high * (1 - rounding);
  }
  bool low{false};
  bool high{false};
};

/// "0.351 or less to 3.84", shorter than the next, of an interval from `low` on.
std::string open_ended(std::string interval, double low, const OwnEnds& own) {
  constexpr std::string_view from_nothing = "up to ";
  constexpr int shown = 3;  // as in an interval
  if (own.low && interval.starts_with(from_nothing)) {
    interval.replace(0, from_nothing.size(), limit_digits(low, true, shown) + " to ");
  }
  if (const std::size_t end = interval.find(" to "); own.low && end != std::string::npos) {
    interval.insert(end, " or less");
  }
  return interval;
}

/// " (the upper end is the program's own limit)"
std::string own_limit(const OwnEnds& own) {
  return !own.low && !own.high
             ? ""
             : format(" ({} the program's own limit)", !own.high ? "the lower end is"
                                                       : own.low ? "both ends are"
                                                                 : "the upper end is");
}

}  // namespace

std::string own_limit_of_hits(const design::WorksFor& served, const design::Problem& problem) {
  return own_limit({served.hit, design::valid_v0(problem), false});
}

void add_works_for(Section& section, const std::optional<design::WorksFor>& served,
                   const ShownTask& task) {
  if (!served) {
    return;
  }
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const auto in_units = [&given = physical](const design::WorksFor& now) {
    return given ? physical_works_for(given->scales, now)
                 : design::PhysicalWorksFor{now.hit, now.p};
  };
  const Interval hits_asked = asked_hits(problem);
  const auto asked =
      in_units({{hits_asked.low, hits_asked.high}, {problem.p, problem.stiffest_p()}});
  const auto works = in_units(*served);
  const auto text = [&](design::ServedInterval design::PhysicalWorksFor::*of) {
    return interval_text(works.*of, {(asked.*of).low, *(asked.*of).high});
  };
  const OwnEnds of_springs(
      served->p,
      pulse ? design::searched_p(pulse_problem(problem, *pulse, ranges)) : design::valid_p(problem),
      physical.has_value(), pulse.has_value());
  const std::string interval = text(&design::PhysicalWorksFor::period_s);
  const auto springs = [in_seconds = physical.has_value()](const std::string& range,
                                                           std::string_view more = "") {
    return format("{} of {}{}{}", in_seconds ? "periods" : "p", range, in_seconds ? " s" : "",
                  more);
  };
  if (pulse) {
    const double k = design::peak_load(*pulse);
    section.row("works for",
                format("k of {} g; {}", interval_text(served->hit, {ranges.k_low.value_or(k), k}),
                       springs(open_ended(interval, works.period_s.low, of_springs),
                               of_springs.high ? " or more" : "")));
    return;
  }
  const std::string_view hit = problem.v0_low ? "every hit of the range"
                               : physical     ? "the hit as given"
                                              : "v0 as given";
  std::string of_hit = own_limit_of_hits(*served, problem);
  constexpr double rounding = 1e-6;
  if (of_hit.empty() && served->hit.low < problem.v0 * (1 - rounding) &&
      *served->hit.high <= problem.v0 * (1 + rounding)) {
    of_hit = ", none stronger than asked for";
  }
  const std::string hits =
      format("{} of {}{}", physical ? "hits" : "v0",
             text(&design::PhysicalWorksFor::velocity_m_per_s), physical ? " m/s" : "");
  section.row("works for", format("{}{}{}", hits,
                                  problem.p_high ? " with every spring of the range" : "", of_hit));
  section.row("", format("{} with {}{}", springs(interval), hit, own_limit(of_springs)));
}

void add_weak_hits(Section& section, const design::Problem& problem, double delta,
                   const Physical& physical) {
  // A weaker hit than this is caught at the start: rule 4 of docs/theory.md, section 2.
  const double caught = std::sqrt(2 * delta);
  if (!problem.v0_low || *problem.v0_low >= caught) {
    return;
  }
  const bool all = problem.v0 <= caught;
  section.row("weak hits",
              format("{} are felt in full, up to {}",
                     all ? "all hits of the range"
                         : "those below " + FigureUnits(physical).velocity_words(caught),
                     impulse_shown(physical, std::min(caught, problem.v0))));
}

double example_width(const Physical& physical, double peak) {
  const double most = peak / 5;
  if (!physical) {
    return most;
  }
  constexpr double usual_m = 0.02;
  const double most_m = most * physical->scales.length_m;
  const double decade = std::pow(10, std::floor(std::log10(most_m)));
  const double digit = most_m / decade;
  return std::min(usual_m, decade * (digit >= 5   ? 5
                                     : digit >= 2 ? 2
                                                  : 1)) /
         physical->scales.length_m;
}

std::string inside_words(const Physical& physical, const Oscillator& damper, double peak,
                         double load) {
  const auto& [p, f, delta, hold] = damper;
  const double width = example_width(physical, peak);
  if (f + delta / width >= load) {
    return load > f ? format("a notch up to {} wide would hold the mass throughout",
                             length_limit(physical, delta / (load - f), false))
                    : "friction alone holds the mass throughout";
  }
  constexpr int digits = 3;
  return format(
      "at most {} g inside one {}: f + delta/w + spring",
      limit_digits(design::notch_acceleration(f, delta, width, p), true, digits),
      physical ? length_shown(physical, width) + " wide" : "as wide as a fifth of the peak");
}

void add_start(Section& section, const StartUnderLoad& start, std::string_view formula,
               const Physical& physical) {
  if (start.delta > 0 && start.load > start.f) {
    section.row("start", format("needs a notch wider than {}, {}",
                                length_limit(physical, start.width(), true), formula));
  }
}

std::string no_notch_words(const StartUnderLoad& start, double peak, std::string_view under,
                           std::string_view load, const Physical& physical) {
  return start.width() < 2 * peak
             ? ""
             : format(
                   "no notch works{}: only one wider than {} would let {} move the mass, but the "
                   "peak is {}",
                   under, length_limit(physical, start.width(), true), load,
                   length_shown(physical, peak));
}

void add_brake(Section& answer, const Physical& physical, double f, std::string key) {
  if (physical && f > 1) {
    answer.row(std::move(key), "friction of more than the weight: a brake, not a bearing",
               Tone::bad);
  }
}

void add_notch_used(Section& section, const ToldPractice& told, const Physical& physical) {
  const auto& [lines, which, at_ends] = told;
  if (lines && lines->notch_used) {
    const double energy = *lines->notch_used * lines->notch_capacity;
    const auto joules = physical ? physical->scales.energy_per_passage_j(energy) : std::nullopt;
    section.row("used at the stop",
                format("{}, {:.3g} % of the notch's capacity{}",
                       joules ? with_unit(*joules, "J") : length_limit(physical, energy, true),
                       100 * *lines->notch_used, which.empty() ? "" : format(" ({})", which)));
  }
}

ToldPractice told_practice(const ShownTask& task, const std::optional<design::Practice>& own,
                           double f, double delta) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  if (own && !pulse && (problem.p_high || problem.v0_low)) {
    return {design::worst_practice(problem, limits, f, delta),
            problem.v0_low != 0.0 ? "worst end of the ranges"
            : problem.p_high      ? "strongest hit, worst end of the springs"
                                  : "strongest hit",
            true};
  }
  ToldPractice told{own, shown_words(task)};
  if (own && own->notch_width_min && pulse) {
    told.lines->notch_width_min = design::least_notch_width_from_rest(
        f, delta, *limits.acceleration_max, problem.stiffest_p(),
        ranges.k_low.value_or(design::peak_load(*pulse)));
  }
  return told;
}

void add_damper(Section& section, const design::DesignPoint& damper, const DeltaNeeds& needs,
                const ToldPractice& told, const Physical& physical) {
  if (needs.published) {
    section.row("Delta1(f)",
                format("{} published (the paper's), {} exact (the motion's own)",
                       length_limit(physical, *needs.published, true),
                       needs.exact ? length_limit(physical, *needs.exact, true) : "none"));
  }
  add_damper_physics(section, physical, damper.f, damper.delta);
  add_notch_used(section, told, physical);
  if (const auto& lines = told.lines; lines && lines->notch_width_min) {
    section.row("notch width",
                format("{} is enough to keep the limit of the acceleration inside it too",
                       length_limit(physical, *lines->notch_width_min, true)));
  }
}

std::string impulse_shown(const Physical& physical, double impulse) {
  const auto newton_seconds = physical ? physical->scales.impulse_n_s(impulse) : std::nullopt;
  return newton_seconds ? with_unit(*newton_seconds, "N s")
         : physical     ? format("{:.4g} N s per kg", impulse * physical->scales.velocity_m_per_s)
                        : format("{:.4g} times the mass", impulse);
}

namespace {

/// With next to no friction it has no meaning but that it is large.
std::string ratio(double value) {
  constexpr double large = 1000;
  constexpr double whole = 100;  // from there on three digits have no point
  return value >= large   ? format("> {:.0f}", large)
         : value >= whole ? format("= {:.0f}", value)
                          : format("= {:.3g}", value);
}

}  // namespace

void add_practice(Section& section, const ToldPractice& told, const Physical& physical) {
  const std::optional<design::Practice>& lines = told.lines;
  if (!lines) {
    return;
  }
  section.row("base shear/weight",
              format("{:.4g}, restoring {:.4g}", lines->base_shear, lines->restoring));
  const auto weight = physical ? physical->scales.friction_force_n(1) : std::nullopt;
  const std::string_view of_end = told.at_ends ? ", at that base shear" : "";
  section.row(
      "secant stiffness",
      !lines->secant_stiffness ? "none"
      : weight
          ? with_unit(*lines->secant_stiffness * *weight / physical->scales.length_m, "N/m") +
                std::string(of_end)
          : format("{:.4g} times the spring's{}", lines->base_shear / lines->restoring, of_end));
  section.row("equiv. damping",
              lines->equivalent_damping
                  ? format("{:.3g} % of critical{}, in a cycle at this peak",
                           100 * *lines->equivalent_damping,
                           lines->notch_capacity > 0 ? " with the notch" : "")
                  : "none: a full cycle at this peak would be damped beyond critical");
  if (lines->energy_ratio && lines->residual_ratio) {
    constexpr double asked = 0.25;  // EN 15129
    const bool enough = *lines->energy_ratio >= asked;
    section.row("re-centring",
                format("E_s / E_h {} without the notch (EN 15129{})", ratio(*lines->energy_ratio),
                       enough ? "" : " needs 0.25"),
                enough ? Tone::plain : Tone::bad);
    section.row("", format("d / d_rm {} (EN 1998-2)", ratio(*lines->residual_ratio)));
  }
  const bool passes = lines->impulse_largest.value_or(0) > lines->impulse_at_stop.value_or(0);
  if (passes) {
    section.row("impulse", format("at most {} at a passage",
                                  impulse_shown(physical, *lines->impulse_largest)));
  }
  if (lines->impulse_at_stop.value_or(0) > 0) {
    section.row(passes ? "" : "impulse",
                impulse_shown(physical, *lines->impulse_at_stop) + " at the stop");
  }
}

}  // namespace stillpoint::report
