// SPDX-License-Identifier: MIT
#include "record/suite_outlook.hpp"

#include "record/suite.hpp"
#include "record/suite_samples.hpp"

#include <variant>
#include <vector>

namespace stillpoint::design {

RecordDesignRequest enlarged(RecordDesignRequest task, double factor) {
  for (LoadCase& each : task.cases) {
    for (SuiteRecord& record : each.records) {
      record.scale *= factor;
    }
    if (each.pulse) {
      std::visit([&](auto& wave) { wave.k *= factor; }, *each.pulse);
    }
    if (each.v0) {
      *each.v0 *= factor;
    }
  }
  return task;
}

SuiteOutlook outlook(const RecordDesignRequest& task, const SuiteDamper& damper, double scale) {
  constexpr std::size_t samples = 48;
  const SuiteSpace space(task, damper.delta > 0 ? SuiteFrictions::both : SuiteFrictions::constant,
                         scale);
  std::vector<SuiteDamper> box;
  for (const SuitePlace& place : box_samples(space, samples)) {
    box.push_back(space.off(damper, place));
  }
  const auto add_worst = [&](const RecordDesignRequest& request,
                             const std::vector<SuiteDamper>& dampers, TaskFigures& worst) {
    worsen(worst, worst_of(Suites(request).figures(dampers, task.threads)));
  };
  SuiteOutlook result;
  for (const double factor : {1 - SuiteOutlook::off, 1 + SuiteOutlook::off}) {
    std::vector<SuiteDamper> of_spring = box;
    for (SuiteDamper& each : of_spring) {
      each.p /= factor;
    }
    add_worst(task, of_spring, result.period);
    add_worst(enlarged(task, factor), box, result.scale);
  }
  return result;
}

}  // namespace stillpoint::design
