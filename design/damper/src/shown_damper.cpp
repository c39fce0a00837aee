// SPDX-License-Identifier: MIT
#include <stillpoint/design/shown_damper.hpp>

#include <stillpoint/core/elementary.hpp>

namespace stillpoint::design {

const PulseWorst* ShownDamper::worst() const {
  return built == nullptr && under_pulse != nullptr && under_pulse->worst ? &*under_pulse->worst
                                                                          : nullptr;
}

const WorstMotions* ShownDamper::tried() const {
  return built != nullptr && built->worst ? &*built->worst : nullptr;
}

double ShownDamper::peak() const {
  return (tried() != nullptr ? tried()->peak.response : response).peak_amplitude;
}

double ShownDamper::felt() const {
  return tried() != nullptr   ? figures_of(tried()->felt.response).acceleration
         : worst() != nullptr ? worst()->acceleration
         : built != nullptr || pulse
             ? figures_of(response).acceleration
             : elementary::hypot(point.f, problem.stiffest_p() * problem.v0);
}

std::optional<double> ShownDamper::felt_outside() const {
  const TriedMotion* const outside = tried() != nullptr ? &tried()->outside : nullptr;
  return design::felt_outside(
      {outside != nullptr ? outside->p : p(), point.f, point.delta}, felt(),
      outside != nullptr ? outside->response.peak_amplitude : response.peak_amplitude,
      built->shape.width);
}

ShownDamper shown_damper(const DesignResult& design, const std::optional<BuiltNotch>& built) {
  const Found& found = *design.finding;
  return {.problem = design.request.problem,
          .limits = design.request.limits,
          .pulse = design.request.pulse,
          .ranges = design.request.pulse_ranges,
          .point = found.point,
          .judged = found,
          .response = built ? built->response : found.response,
          .energies = built ? built->energies : *found.energies,
          .under_pulse = found.pulse ? &*found.pulse : nullptr,
          .built = built ? &*built : nullptr};
}

ShownDamper shown_damper(const RegionRequest& request, const RegionAnswer& answer) {
  return {.problem = request.problem,
          .limits = request.limits,
          .pulse = request.pulse,
          .ranges = request.pulse_ranges,
          .point = {*request.f, *request.delta, answer.tolerance.value_or(0)},
          .judged = answer,
          .response = *answer.response,
          .energies = *answer.energies,
          .under_pulse = answer.under_pulse ? &*answer.under_pulse : nullptr,
          .admissible = answer.tolerance.has_value()};
}

SimulationRequest motion_of(const ShownDamper& damper) {
  SimulationRequest request;
  request.oscillator = {damper.p(), damper.point.f, damper.point.delta};
  request.start = {0, damper.problem.v0};
  if (damper.under_pulse != nullptr) {
    request.start = {0, 0};
    request.excitation = excitation(damper.under_pulse->pulse);
  }
  if (damper.built != nullptr) {
    request.oscillator.hold = damper.built->shape.hold;
    request.surface.notch_width = damper.built->shape.width;
  }
  return request;
}

std::optional<double> felt_outside(const Oscillator& damper, double felt, double peak,
                                   const std::optional<double>& notch_width) {
  // It slides at the largest acceleration outside, f + p^2 |x|, where it is farthest.
  const double outside = damper.f + damper.p * damper.p * peak;
  return notch_width.value_or(0) / 2 < peak && exceeds(felt, outside) ? std::optional(outside)
                                                                      : std::nullopt;
}

}  // namespace stillpoint::design
