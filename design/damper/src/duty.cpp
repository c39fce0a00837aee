// SPDX-License-Identifier: MIT
#include <stillpoint/design/duty.hpp>

#include <algorithm>

namespace stillpoint::design {

namespace {

void include(Duty& duty, const MotionEnergies& motion) {
  duty.peak_velocity = std::max(duty.peak_velocity, motion.peak_velocity);
  if (const auto& now = motion.energies) {
    for (const auto part :
         {&Energies::friction, &Energies::notch, &Energies::damping, &Energies::slip_path}) {
      duty.most.*part = std::max(duty.most.*part, (*now).*part);
    }
  }
}

}  // namespace

Duty duty_of(const ShownDamper& damper) {
  const SimulationRequest motion = motion_of(damper);
  Duty duty{.motion = std::string(damper.pulse ? name(*damper.pulse) : "hit"),
            .stroke = damper.peak(),
            .cycle = full_cycle(motion.oscillator, damper.peak(), motion.surface.notch_width)};
  if (const auto& worst = damper.judged.stroke_worst) {
    // Under a pulse it is that of the first swing; a later one may reach farther.
    duty.stroke_worst = std::max(*worst, duty.stroke);
  }
  include(duty, damper.energies);
  return duty;
}

std::vector<Duty> duties_of(const RecordDesign& design) {
  const RecordFinding& finding = *design.finding;
  const SuiteDamper& damper = finding.point.damper;
  const bool exact = design.request.tolerance.exact();
  std::vector<Duty> duties;
  for (std::size_t c = 0; c < design.request.cases.size(); ++c) {
    const std::vector<ForcedResponse>& all = finding.responses[c];
    const auto farthest = std::ranges::max_element(all, {}, &ForcedResponse::peak_amplitude);
    Duty duty{.index = static_cast<std::size_t>(farthest - all.begin()),
              .stroke = finding.point.figures[c].peak};
    const CaseMotion motion = motions_of(design.request.cases[c])[duty.index];
    duty.motion = motion.name;
    if (!exact) {
      duty.stroke_worst = finding.box.worst[c].peak;
    }
    for (const MotionEnergies& now : finding.energies[c]) {
      include(duty, now);
    }
    duty.cycle =
        full_cycle(oscillator_of(design.request, damper), duty.stroke, damper.notch_width());
    duties.push_back(duty);
  }
  return duties;
}

}  // namespace stillpoint::design
