// SPDX-License-Identifier: MIT
#include "sections.hpp"
#include "format.hpp"

#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

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
  const std::string friction = !f        ? "as little constant friction as you can"
                               : weighed ? "a friction force of " + with_unit(*force, "N")
                               : digits  ? format("f = {:.{}g}", *f, *digits)
                                         : format("f = {}", *f);
  return delta == 0 ? friction + " without a notch"
         : weighed  ? format("{} and a notch{}{} takes {} at a passage", friction, which,
                            shape.hold ? " and" : " that", with_unit(*energy, "J"))
                    : format("{} and delta = {}{}", friction, length_shown(physical, delta, digits),
                            which.empty() ? "" : " in a notch" + which);
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
         (stiffness ? format(" (stiffness {})", with_unit(*stiffness, "N/m")) : "");
}

std::string_view jumps_words(double delta, const std::optional<double>& width) {
  return delta > 0 && !width ? " between the velocity jumps at the notch" : "";
}

}  // namespace stillpoint::report
