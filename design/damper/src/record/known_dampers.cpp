// SPDX-License-Identifier: MIT
#include "record/known_dampers.hpp"

namespace stillpoint::design {

void KnownDampers::add(std::span<const SuiteDamper> dampers, std::span<const TaskFigures> figures) {
  for (const SuiteDamper& damper : dampers) {
    SuitePlace values{};
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      values.at(i) = axes_[i].value(damper);
    }
    values_.push_back(values);
  }
  figures_.insert(figures_.end(), figures.begin(), figures.end());
}

void KnownDampers::add(const KnownDampers& others) {
  values_.insert(values_.end(), others.values_.begin(), others.values_.end());
  figures_.insert(figures_.end(), others.figures_.begin(), others.figures_.end());
}

KnownDampers KnownDampers::breaking(const std::vector<SuiteLimits>& limits) const {
  KnownDampers some(axes_);
  for (std::size_t k = 0; k < values_.size(); ++k) {
    if (!admissible(figures_[k], limits)) {
      some.values_.push_back(values_[k]);
      some.figures_.push_back(figures_[k]);
    }
  }
  return some;
}

TaskFigures KnownDampers::worst(const SuiteDamper& nominal) const {
  constexpr double rounding = 1e-12;  // of a period, which a damper has as 1/p
  SuitePlace low{};
  SuitePlace high{};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const SuiteAxis& axis = axes_[i];
    const double value = axis.value(nominal);
    low.at(i) = value * (1 - axis.spread().below) * (1 - rounding);
    high.at(i) = value * (1 + axis.spread().above) * (1 + rounding);
  }
  TaskFigures all;
  for (std::size_t k = 0; k < values_.size(); ++k) {
    bool inside = true;
    for (std::size_t i = 0; i < most_axes && inside; ++i) {
      inside = low[i] <= values_[k][i] && values_[k][i] <= high[i];
    }
    if (inside) {
      worsen(all, figures_[k]);
    }
  }
  return all;
}

}  // namespace stillpoint::design
