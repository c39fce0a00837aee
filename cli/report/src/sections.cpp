// SPDX-License-Identifier: MIT
// What several reports say of a damper, its motion and its check.
#include "sections.hpp"

#include <stillpoint/core/names.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <numbers>

namespace stillpoint::report {

std::string damper_words(const Physical& physical, const std::optional<double>& f, double delta,
                         const design::NotchShape& shape, std::optional<int> digits) {
  const auto force = physical ? physical->scales.friction_force_n(f.value_or(0)) : std::nullopt;
  const auto energy = physical ? physical->scales.energy_per_passage_j(delta) : std::nullopt;
  const bool weighed = force && energy && std::isfinite(*energy);
  const std::string which = shape.width  ? format(" {} wide", length_shown(physical, *shape.width))
                            : shape.hold ? format(" that lets go at {} above the friction",
                                                  acceleration_shown(*shape.hold))
                                         : "";
  const std::string friction = !f                   ? "as little constant friction as possible"
                               : weighed && *f == 0 ? "no constant friction"
                               : weighed ? "a friction force of " + si_words(physical, *force, "N")
                               : digits  ? format("f = {:.{}g}", *f, *digits)
                                         : format("f = {}", *f);
  const std::string notch =
      format("a notch{}{} takes {} at a passage", which, shape.hold ? " and" : " that",
             weighed ? si_words(physical, *energy, "J") : "");
  return delta == 0          ? friction + " without a notch"
         : weighed && f == 0 ? notch + ", without constant friction"
         : weighed           ? format("{} and {}", friction, notch)
                   : format("{} and delta = {}{}", friction, length_shown(physical, delta, digits),
                            which.empty() ? "" : " in a notch" + which);
}

std::string force_beside(const Physical& physical, double f) {
  const auto force = physical ? physical->scales.friction_force_n(f) : std::nullopt;
  return force ? format(" ({} of friction)", si_words(physical, *force, "N")) : "";
}

std::string period_words(const Physical& physical, double p, std::optional<int> digits) {
  return physical ? format("a period of {:.{}g} s",
                           2 * std::numbers::pi / p * physical->scales.time_s, digits.value_or(4))
                  : format("p = {:.{}g}", p, digits.value_or(6));
}

std::string spring_words(const Physical& physical, double p, std::optional<int> digits) {
  std::optional<double> stiffness;
  if (physical) {
    design::Scales scales = physical->scales;
    scales.omega_rad_per_s = p / scales.time_s;
    stiffness = scales.stiffness_n_per_m();
  }
  return period_words(physical, p, digits) +
         (stiffness ? format(" (stiffness {})", si_words(physical, *stiffness, "N/m")) : "");
}

std::string_view jumps_words(double delta, const std::optional<double>& width) {
  return delta > 0 && !width ? " between the velocity jumps at the notch" : "";
}

std::string feasible_words(std::span<const Interval> f) {
  std::string words;
  for (const auto& [low, high] : f) {
    words += (words.empty() ? "" : " or ") + interval_digits(low, high, digits_of_region);
  }
  return words;
}

std::string delta_words(std::span<const Interval> all, const Physical& physical) {
  constexpr std::size_t most_listed = 3;
  constexpr double conversion = 1 + 1e-12;  // the rounding of 3 mm to dimensionless and back
  const std::size_t left_out = all.size() - std::min(all.size(), most_listed);
  std::string text;
  for (const auto& [low, high] : all.subspan(left_out)) {
    const std::string least = length_limit(physical, low, true);
    const std::string most = length_limit(physical, high * conversion, false);
    text += format("{}{}", text.empty() ? "" : " or ",
                   std::isinf(high)                ? "at least " + least
                   : !begins_at_nothing(low, high) ? format("{} to {}", least, most)
                                                   : "up to " + most);
  }
  return text + (left_out > 0 ? " or in lower ranges" : "");
}

std::string interval_text(const design::ServedInterval& interval) {
  constexpr int shown = 3;
  constexpr double conversion = 1e-12;  // the rounding of 0.44 m/s to dimensionless and back
  constexpr double beyond_all = 1e30;   // an end that is the program's own limit, not the damper's
  constexpr double apart = 1e-6;
  const double low = interval.low < 1 / beyond_all ? 0 : interval.low * (1 - conversion);
  const double high = interval.high.value_or(HUGE_VAL) * (1 + conversion);
  return high < beyond_all ? high - low <= apart * high
                                 ? format("exactly {}", decimal_within(low, high))
                                 : interval_digits(low, high)
         : low == 0 ? "any size"
                           : format("at least {}", limit_digits(low, true, shown));
}

void add_works_for(Section& section, const std::optional<design::WorksFor>& served,
                   const Physical& physical) {
  if (!served) {
    return;
  }
  const auto more = [](const design::ServedInterval& interval) {
    return interval.ends_search ? ", perhaps beyond" : "";
  };
  const auto works = physical ? physical_works_for(physical->scales, *served)
                              : design::PhysicalWorksFor{served->hit, served->p};
  const Unit speed = read_in(physical, "m/s");
  const auto of_speed = [&](design::ServedInterval interval) {
    interval.low = interval.low * speed;
    interval.high = *interval.high * speed;
    return interval_text(interval);
  };
  using enum design::ServedLoad;
  section.row(
      "works for",
      served->load == k ? format("k of {} g{}", interval_text(served->hit), more(served->hit))
      : served->load == scale
          ? format("{} times the loads{}", interval_text(served->hit), more(served->hit))
          : format("{} of {}{}{}", physical ? "hits" : "v0", of_speed(works.velocity_m_per_s),
                   physical ? with_blank(speed.name) : "", more(served->hit)));
  section.row("", format("{} of {}{}{}, {}the other as given", physical ? "periods" : "p",
                         interval_text(works.period_s), physical ? " s" : "", more(served->p),
                         served->p.ends_search ? "" : "each with "));
}

std::string box_words(const design::SuiteBox& box, bool holds) {
  const bool one =
      box.f.low == box.f.high && box.delta.low == box.delta.high && box.width.low == box.width.high;
  if (box.exact) {
    return one ? "nothing within the ranges is worse than at their ends"
               : "no damper within the tolerance is worse than at its corners";
  }
  return format("{} {} {}, corners and boundary included", holds ? "no failure in" : "the worst of",
                box.samples, one ? "motions within the ranges" : "dampers within the tolerance");
}

void add_check(Section& answer, const design::CrossCheck& check) {
  const double most =
      std::ranges::max(check.methods, {}, &design::CheckMethod::relative_error).relative_error;
  answer.row("checks",
             format("{} independent method{}{}", check.methods.size(),
                    check.methods.size() == 1 ? (check.passed ? " agrees" : " DISAGREES")
                    : check.passed            ? "s agree"
                                              : "s DISAGREE",
                    most == 0 ? " exactly" : format(" to within {:.1e}", most)),
             check.passed ? Tone::good : Tone::bad);
}

void add_damping(Section& answer, const Oscillator& oscillator, double most_zeta) {
  const bool varies = most_zeta > oscillator.zeta;
  if (varies || oscillator.zeta > 0) {
    answer.row("damping", format("{:.4g}{} % of critical damping", 100 * oscillator.zeta,
                                 varies ? format(" to {:.4g}", 100 * most_zeta) : ""));
  }
  if (oscillator.breakaway > 1) {
    answer.row("breakaway",
               format("at rest friction holds {:.4g} times as much", oscillator.breakaway));
  }
}

void add_start(Section& answer, double least_width, const Response& response,
               const Physical& physical) {
  if (least_width < 2 * response.peak_amplitude) {
    answer.row("start", "needs a notch wider than " + length_limit(physical, least_width, true));
  }
}

std::string outcome_phrase(Outcome outcome) {
  return std::string(texts::line_of("words/outcomes.txt", name(outcome)));
}

std::string outcome_phrase(const ForcedResponse& response) {
  return response.outcome != Outcome::running || response.final_velocity != 0
             ? outcome_phrase(response.outcome)
             : "is at rest at the end of the run";
}

}  // namespace stillpoint::report
