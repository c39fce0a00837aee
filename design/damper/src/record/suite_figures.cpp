// SPDX-License-Identifier: MIT
#include "record/suite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace stillpoint::design {

namespace {

/// For a damper that never rests: worse than any that does.
constexpr double never_rests = 1e9;

}  // namespace

SuiteFigures suite_figures(const ForcedResponse& response) {
  const Figures figures = figures_of(response);
  return {figures.peak,
          figures.acceleration,
          figures.residual.value(),
          response.decision_margin.value_or(1),
          figures.jump,
          0,
          response.zero_passages.value_or(0),
          response.stop_time.value_or(0),
          true};
}

bool limits_any(const RecordDesignRequest& request, std::optional<double> SuiteLimits::*limit) {
  return std::ranges::any_of(
      request.cases, [limit](const LoadCase& each) { return (each.limits.*limit).has_value(); });
}

const SuiteFigureKind& minimised(const RecordDesignRequest& request) {
  return *std::ranges::find_if(suite_figure_kinds, [&](const SuiteFigureKind& kind) {
    return request.objective == SuiteObjective::robust ? limits_any(request, kind.limit)
                                                       : kind.objective == request.objective;
  });
}

SuiteFigures worse(const SuiteFigures& one, const SuiteFigures& other) {
  return {std::max(one.peak, other.peak),
          std::max(one.acceleration, other.acceleration),
          std::max(one.residual, other.residual),
          std::min(one.margin, other.margin),
          std::max(one.jump, other.jump),
          std::max(one.late, other.late),
          std::max(one.passages, other.passages),
          std::max(one.stop_time, other.stop_time),
          one.settled && other.settled};
}

void worsen(std::span<SuiteFigures> worst, EachFigures other) {
  for (std::size_t i = 0; i < worst.size(); ++i) {
    worst[i] = worse(worst[i], other[i]);
  }
}

void worsen(TaskFigures& worst, EachFigures other) {
  const std::size_t both = std::min(worst.size(), other.size());
  worsen(std::span(worst).first(both), other);
  worst.insert(worst.end(), other.begin() + static_cast<std::ptrdiff_t>(both), other.end());
}

TaskFigures worse(TaskFigures one, const TaskFigures& other) {
  worsen(one, other);
  return one;
}

TaskFigures worst_of(std::span<const TaskFigures> all) {
  TaskFigures worst;
  for (const TaskFigures& each : all) {
    worsen(worst, each);
  }
  return worst;
}

SuiteFigures largest(EachFigures figures) {
  return std::accumulate(figures.begin(), figures.end(), SuiteFigures(),
                         [](const SuiteFigures& a, const SuiteFigures& b) { return worse(a, b); });
}

bool settled(EachFigures figures) {
  return !figures.empty() && std::ranges::all_of(figures, &SuiteFigures::settled);
}

SuiteDamper relative_to(const SuiteDamper& damper, double factor) {
  SuiteDamper relative = damper;
  relative.f /= factor;
  relative.delta /= factor * factor;
  relative.width /= factor;
  return relative;
}

SuiteFigures times(SuiteFigures figures, double factor) {
  for (const auto figure : figures_of_load) {
    figures.*figure *= factor;
  }
  return figures;
}

std::vector<SuiteLimits> limits_of(const RecordDesignRequest& request) {
  std::vector<SuiteLimits> list;
  for (const LoadCase& each : request.cases) {
    list.push_back(each.limits);
  }
  return list;
}

std::vector<Constraint> constraints_of(const RecordDesignRequest& task, const TaskFigures& worst) {
  std::vector<Constraint> list;
  for (std::size_t c = 0; c < task.cases.size(); ++c) {
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      if (const std::optional<double>& limit = task.cases[c].limits.*kind.limit) {
        Constraint& now = list.emplace_back(Constraint::compared(
            kind.constraint, kind.variable, "<=", worst[c].*kind.value, *limit));
        now.in_case = task.cases[c].name;
        now.known = worst[c].settled;
        now.satisfied = now.satisfied && worst[c].settled;
      }
    }
  }
  return list;
}

double excess(const SuiteFigures& figures, const SuiteLimits& limits) {
  if (!figures.settled) {
    return never_rests;
  }
  double off = 0;
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& limit = limits.*kind.limit;
    const double value = figures.*kind.value;
    if (limit && value > *limit) {
      off += (value - *limit) / (*limit > 0                             ? *limit
                                 : kind.limit == &SuiteLimits::passages ? 1
                                                                        : figures.peak);
    }
  }
  if (limits.late && figures.late > *limits.late) {
    off += figures.late / *limits.late - 1;
  }
  return std::min(off, never_rests);
}

double excess(EachFigures figures, const std::vector<SuiteLimits>& limits) {
  double off = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    off += excess(figures[i], limits[i]);
  }
  return std::min(off, never_rests);
}

double use(EachFigures figures, const std::vector<SuiteLimits>& limits) {
  double most = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      const std::optional<double>& limit = limits[i].*kind.limit;
      if (limit && *limit > 0) {
        most = std::max(most, figures[i].*kind.value / *limit);
      }
    }
  }
  return most;
}

double SuiteGoal::value(EachFigures figures) const {
  if (figure == nullptr) {
    return use(figures, limits);
  }
  double most = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    most = in_case.value_or(i) == i ? std::max(most, figures[i].*figure) : most;
  }
  return most;
}

SuiteRank rank(EachFigures figures, const SuiteGoal& goal) {
  if (!figures.empty() && !settled(figures)) {
    return {never_rests, 0, 0};
  }
  return {excess(figures, goal.limits), goal.value(figures), largest(figures).peak};
}

bool admissible(EachFigures figures, const std::vector<SuiteLimits>& limits) {
  return excess(figures, limits) == 0;
}

}  // namespace stillpoint::design
