// SPDX-License-Identifier: MIT
#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/records/decimal.hpp>

#include "region/edges.hpp"
#include "region/reason.hpp"
#include "way/way.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace stillpoint::design {

namespace {

/// The requirement that no damper meets.
std::string no_way(const Problem& problem, const std::string& box) {
  const std::string_view every = problem.v0_low && problem.p_high
                                     ? " for every hit and spring of the ranges"
                                 : problem.v0_low ? " for every hit of the range"
                                 : problem.p_high ? " for every spring of the range"
                                                  : "";
  return fmt::format(
      "no damper {} within {} half-cycle{}{}{}",
      problem.residual ? "brings the mass to rest within the residual" : "stops the mass at x = 0",
      problem.arrivals, problem.arrivals > 1 ? "s" : "", every, box);
}

/// With six digits, rounded up or down: a number as printed is enough.
std::string six_digits(double value, records::Rounding rounding) {
  constexpr double conversion = 1e-12;  // the rounding of 150 mm to dimensionless and back
  const double edge = value * (rounding == records::Rounding::up ? 1 - conversion : 1 + conversion);
  return fmt::format("{:.6g}", records::decimal(edge, 6, rounding));
}

/// What is needed and what is allowed, which is less, or all digits if six do not distinguish them.
std::pair<std::string, std::string> told_apart(double a, double b, const std::string& unit = {}) {
  const std::string behind = unit.empty() ? "" : " " + unit;
  std::pair six{six_digits(a, records::Rounding::up) + behind,
                six_digits(b, records::Rounding::down) + behind};
  return six.first != six.second
             ? six
             : std::pair{fmt::format("{}{}", a, behind), fmt::format("{}{}", b, behind)};
}

/// "beta", or the stroke if there are units.
std::string stroke(const Problem& problem, const ReasonUnits& units) {
  return units.delta_unit.empty()
             ? "beta"
             : fmt::format("{:.6g} {}", problem.beta * units.delta, units.delta_unit);
}

/// f2 is above `most`, which is `what`, or leaves too little below it.
std::string too_much_friction(const Region& region, double most, const std::string& stroke,
                              std::string_view what, const std::string& box) {
  const auto [least, allowed] = told_apart(region.f2, most);
  return fmt::format("a peak within {} needs f >= {}, but {} {}{}", stroke, least, what, allowed,
                     none_between("f", region.f2, most, box));
}

/// A figure that is above its limit without friction.
std::string limit_alone(const LimitKind& kind, const Problem& problem, double limit) {
  const auto& figure = kind.figure.value();
  const auto [least, most] = told_apart(figure.least(problem), limit);
  return fmt::format("even without friction the {} is {}{}, above the limit of {}{}", kind.quantity,
                     least, kind.unit, most, kind.unit);
}

std::string amplitude_against(const LimitKind& kind, const Region& region, const Problem& problem,
                              double limit, const std::string& stroke, const std::string& box) {
  if (!kind.figure) {
    return too_much_friction(region, limit, stroke, "f may be at most", box);
  }
  return too_much_friction(
      region, kind.figure->edge(problem, limit), stroke,
      fmt::format("a {} within {:.6g}{} needs f <=", kind.quantity, limit, kind.unit), box);
}

/// For one hit and one spring.
std::string no_arrival(const Problem& problem, const Limits& limits, const ReasonUnits& units,
                       const std::string& box) {
  const Edges edge = edges(problem, limits);
  const double f = highest_centre(edge.f_cap, limits.tolerance) * (1 - limits.tolerance);
  const double delta = highest_centre(edge.delta_cap, limits.tolerance) * (1 - limits.tolerance);
  const auto last = static_cast<int>(problem.arrivals);
  const double pass = way_speeds(Way(problem, {}, last), f, delta).pass;
  const auto [least, most] =
      told_apart(problem.v0 * units.velocity, pass * units.velocity, units.velocity_unit);
  return problem.v0 >= pass
             ? fmt::format(
                   "even with the largest friction allowed the mass passes x = 0 {} times: v0 = {} "
                   "would have to be below {}{}",
                   last, least, most, box)
             : fmt::format(
                   "no damper stops the mass at any of its first {} arrivals within the limits{}",
                   last, box);
}

/// Delta is bounded from above, by `what`.
std::string too_fast(const Problem& problem, const Limits& limits, const ReasonUnits& units,
                     std::string_view what, const std::string& box) {
  const Edges edge = edges(problem, limits);
  const auto needed = [&](double f) { return delta1(problem, f).value_or(0); };
  const bool alone = needed(edge.f_cap) >= edge.delta_cap;
  const double f = alone ? edge.f_cap : highest_centre(edge.f_cap, limits.tolerance);
  const double needs = needed(alone ? f : f * (1 - limits.tolerance));
  const auto [least, most] =
      told_apart(needs * units.delta, edge.delta_cap * units.delta, units.delta_unit);
  return fmt::format("even at the largest f, {:.6g}, stopping needs delta > {}, but {} {}{}", f,
                     least, what, most,
                     alone                    ? ""
                     : needs < edge.delta_cap ? none_between("delta", needs, edge.delta_cap, box)
                                              : box);
}

}  // namespace

std::optional<std::vector<std::string_view>> conflicting(const Region& region) {
  const std::string_view limit = region.limit != nullptr ? region.limit->constraint : "";
  using Names = std::vector<std::string_view>;
  const std::array<Names, 9> all{{{},  // in the order of Conflict
                                  {"amplitude", "return"},
                                  {"amplitude", "dead_zone"},
                                  {"amplitude", limit},
                                  {limit},
                                  {"stop", "start"},
                                  {"stop", limit},
                                  {"stop", "arrivals"},
                                  {"rounding"}}};
  const Names& names = all.at(static_cast<std::size_t>(region.conflict));
  return names.empty() ? std::nullopt : std::optional(names);
}

std::optional<std::string> reason(const Region& region, const Problem& problem,
                                  const Limits& limits, const ReasonUnits& units) {
  const std::string box = limits.tolerance > 0
                              ? fmt::format(", with a tolerance of {:g} %", 100 * limits.tolerance)
                              : "";
  const std::string allowed = stroke(problem, units);
  const double limit = region.limit == nullptr ? 0 : (limits.*region.limit->value).value();
  switch (region.conflict) {
    case Conflict::none:
      break;
    case Conflict::amplitude_against_return:
      return problem.residual ? too_much_friction(region, largest_f(problem), allowed,
                                                  "if friction cannot hold the mass there, coming "
                                                  "to rest within the residual needs f <=",
                                                  box)
                              : too_much_friction(region, region.f3, allowed,
                                                  "coming back to x = 0 needs f <=", box);
    case Conflict::amplitude_against_dead_zone:
      return too_much_friction(region, region.f1, allowed,
                               "friction could hold the mass there unless f <", box);
    case Conflict::amplitude_against_limit:
      return amplitude_against(*region.limit, region, problem, limit, allowed, box);
    case Conflict::limit_alone:
      return limit_alone(*region.limit, problem, limit);
    case Conflict::narrower_than_rounding:
      return "the constraints leave a region narrower than rounding: no damper is that exact";
    case Conflict::no_arrival:
      return is_plain(problem, limits) ? no_arrival(problem, limits, units, box)
                                       : no_way(problem, box);
    case Conflict::stop_against_start:
      return too_fast(problem, limits, units, "starting needs delta <=", box);
    case Conflict::stop_against_limit:
      if (needs_a_notch(problem, limits)) {
        return "without a notch (delta = 0) the mass rests up to f/p^2 off centre, not at x = 0; "
               "allow a residual";
      }
      return too_fast(problem, limits, units, "delta may be at most", box);
  }
  return std::nullopt;
}

}  // namespace stillpoint::design
