// SPDX-License-Identifier: MIT
#include <stillpoint/design/record_design.hpp>

#include "record/suite.hpp"
#include "record/suite_check.hpp"
#include "record/suite_judge.hpp"
#include "record/suite_outlook.hpp"
#include "record/suite_region.hpp"
#include "record/suite_request.hpp"
#include "record/suite_served.hpp"
#include "record/suite_task_search.hpp"
#include "record/suite_watch.hpp"
#include "record/task_along_f.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/seconds.hpp>
#include <stillpoint/design/record_findings.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace stillpoint::design {

namespace {

/// 1 +- the tolerance of what the box allows to be off.
Interval interval_about(double value, const Spread& spread) {
  return {value * (1 - spread.below), value * (1 + spread.above)};
}

SuiteBox promised(const RecordDesignRequest& task, const ChosenBox& chosen) {
  const auto& [damper, worst, rank] = chosen.verified.box;
  const SuiteTolerance& of = task.tolerance;
  const Interval periods =
      interval_about(1 / damper.p, combined(task.spring, times(of.period, chosen.scale)));
  return {interval_about(damper.f, times(of.f, chosen.scale)),
          interval_about(damper.delta, times(of.delta, chosen.scale)),
          {1 / periods.high, 1 / periods.low},
          interval_about(damper.width, times(of.width, chosen.scale)),
          chosen.verified.samples,
          worst_at_corners(task),
          worst,
          chosen.verified.of,
          {}};
}

/// With the motion that has the most of each figure that is limited.
void add_motions(RecordDesign& result, const Suites& suites) {
  SuiteBox& box = result.finding->box;
  auto constraint = result.constraints.begin();
  for (std::size_t c = 0; c < suites.cases().size(); ++c) {
    const Suite& suite = suites.cases()[c];
    const bool tells_motions = suites.cases().size() > 1 ||
                               (suite.motions().size() > 1 && !is_mean(result.request.cases[c]));
    box.in.emplace_back();
    for (std::size_t k = 0; k < suite_figure_kinds.size(); ++k) {
      const SuiteFigureKind& kind = suite_figure_kinds.at(k);
      const std::size_t motion = suite.worst_motion(box.of[c].at(k), kind);
      box.in.back().at(k) = motion;
      if (result.request.cases[c].limits.*kind.limit) {
        const CaseMotion& worst = suite.motions()[motion];
        if (tells_motions) {
          constraint->motion = {worst.name, worst.scale};
        }
        ++constraint;
      }
    }
  }
}

/// The middles of even cells over a range, and as many of the same size beyond it as boxes reach.
struct Cells {
  Cells(const Interval& range, int side, const Spread& of) : count(side), spread(of) {
    const double size = (range.high - range.low) / side;
    for (double at = range.low - size / 2; size > 0 && at > range.low * (1 - of.below) && at > 0;
         at -= size) {
      all.push_back(at);
    }
    std::ranges::reverse(all);
    before = all.size();
    for (int i = 0; i < side; ++i) {
      all.push_back(range.low + (range.high - range.low) * (i + 0.5) / side);
    }
    for (double at = range.high + size / 2; size > 0 && at < range.high * (1 + of.above);
         at += size) {
      all.push_back(at);
    }
  }

  [[nodiscard]] std::vector<double> shown() const {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(before);
    return {first, first + count};
  }
  /// The cells from and to whose middle a built value may be, its own at least.
  [[nodiscard]] std::pair<std::size_t, std::size_t> within(double value) const {
    const auto first = std::ranges::lower_bound(all, std::min(value, value * (1 - spread.below)));
    const auto end = std::ranges::upper_bound(all, value * (1 + spread.above));
    return {static_cast<std::size_t>(first - all.begin()),
            static_cast<std::size_t>(end - all.begin())};
  }

  int count;
  Spread spread;
  std::size_t before{0};
  std::vector<double> all;
};

std::optional<ChosenBox> found(const Suites& suites, RecordDesign& result, SuiteWatch& watch) {
  const RecordDesignRequest& task = result.request;
  return !task.parts.empty() ? best_part(suites, result, watch)
         : task.judges       ? judged(suites, result, watch)
                             : searched(suites, result, watch);
}

}  // namespace

std::size_t worst_motion(const RecordDesign& result, std::size_t in_case) {
  const std::vector<ForcedResponse>& all = result.finding->responses[in_case];
  const auto value = [&](const ForcedResponse& response) {
    return suite_figures(response).*minimised(result.request).value;
  };
  constexpr double same = 1 - 1e-9;  // f + hold is felt under every record that frees the mass
  const double most = value(*std::ranges::max_element(all, {}, value));
  const auto peak_of_worst = [&](const ForcedResponse& response) {
    return value(response) >= same * most ? response.peak_amplitude : -1;
  };
  return static_cast<std::size_t>(std::ranges::max_element(all, {}, peak_of_worst) - all.begin());
}

RecordDesign design(const RecordDesignRequest& request, const RecordWatch& go_on) {
  require_valid(request);
  const double begun = seconds_now();
  RecordDesign result;
  result.request = completed(request);
  const RecordDesignRequest& task = result.request;
  const Suites suites(task);
  if (task.maps) {
    const auto known = TaskAlongF::of(task);
    result.region = known ? known->feasible() : std::nullopt;
    if (!result.region) {
      result.region = feasible_region(suites, task);
    }
    return result;
  }
  SuiteWatch watch(go_on);
  const std::optional<ChosenBox> chosen = found(suites, result, watch);
  result.search.evaluations = watch.evaluations();
  result.search.interrupted = watch.stopped();
  result.search.status = watch.stopped() ? "INTERRUPTED" : "SUCCESS";
  if (chosen) {
    const SuiteDamper& damper = chosen->verified.box.damper;
    RecordFinding finding;
    finding.point = {damper, suites.figures(damper)};
    for (const Suite& each : suites.cases()) {
      finding.responses.push_back(each.responses(damper));
      finding.energies.emplace_back();
      for (const CaseMotion& motion : each.motions()) {
        finding.energies.back().push_back(energies_of(motion_of(task, damper, motion)));
      }
    }
    finding.box = promised(task, *chosen);
    finding.outlook = outlook(task, damper, chosen->scale);
    finding.cross_check = check(suites, damper, finding.responses);
    finding.works_for = works_for(task, damper);
    result.nearest = {damper, chosen->verified.box.worst};
    result.constraints = constraints_of(task, finding.box.worst);
    result.finding = std::move(finding);
    add_motions(result, suites);
    if (task.judges || std::ranges::none_of(task.cases, &LoadCase::of_records)) {
      std::ranges::move(constraints_on(task, damper, chosen->scale),
                        std::back_inserter(result.constraints));
    }
    if (task.judges) {
      result.finding->admissible = std::ranges::all_of(result.constraints, &Constraint::satisfied);
      if (task.tolerance.exact() && !result.finding->admissible) {
        result.finding->works_for.reset();
      }
      result.finding->part = result.parts.empty() ? "" : result.parts.front().part.name;
    }
  }
  result.findings = findings_of(result, request);
  result.search.wall_time_s = seconds_now() - begun;
  return result;
}

std::optional<Governing> governing(const RecordDesign& result, std::size_t in_case) {
  std::optional<Governing> least;
  for (const Constraint& now : result.constraints) {
    const double left = part_left(now);
    const auto* const kind =
        std::ranges::find(suite_figure_kinds, now.name, &SuiteFigureKind::constraint);
    if (kind != suite_figure_kinds.end() && now.in_case == result.request.cases[in_case].name &&
        (now.limit > 0 || left < 0) && (!least || left < least->part_left)) {
      least.emplace(Governing{now, left,
                              result.finding->box.of[in_case].at(
                                  static_cast<std::size_t>(kind - suite_figure_kinds.begin()))});
    }
  }
  return least;
}

TaskFigures figures_of(const RecordDesignRequest& request, const SuiteDamper& damper) {
  return Suites(request).figures(damper);
}

SuiteMap suite_map(const RecordDesignRequest& request, const SuiteDamper& damper, bool boxes,
                   int side) {
  require_valid(request);
  require_within("side", side, 1, 10'000);
  const RecordDesignRequest task = completed(request);
  const SuiteTolerance& of = task.tolerance;
  const Cells f(*task.f, side, boxes ? of.f : Spread());
  const Cells delta(*task.delta, side, boxes ? of.delta : Spread());
  std::vector<double> widths{damper.width};
  if (boxes && damper.width > 0 && of.width.below + of.width.above > 0) {
    widths.push_back(damper.width * (1 - of.width.below));
    widths.push_back(damper.width * (1 + of.width.above));
  }
  const std::vector<double> dampings =
      task.zeta.low < task.zeta.high ? std::vector{0.0, 1.0} : std::vector{0.0};
  std::vector<SuiteDamper> dampers;
  for (const double of_f : f.all) {
    for (const double of_delta : delta.all) {
      for (const double width : widths) {
        for (const double damping : dampings) {
          dampers.push_back({damper.p, of_f, of_delta, width, 1, damping});
        }
      }
    }
  }
  const std::size_t of_place = widths.size() * dampings.size();
  const std::vector<TaskFigures> figures = Suites(task).figures(dampers, task.threads);
  SuiteMap map{f.shown(), delta.shown(), {}};
  for (const double of_f : map.f) {
    const auto [first, end] = f.within(of_f);
    for (const double of_delta : map.delta) {
      const auto [low, high] = delta.within(of_delta);
      TaskFigures worst;
      for (std::size_t i = first; i < end; ++i) {
        const auto row =
            figures.begin() + static_cast<std::ptrdiff_t>(i * delta.all.size() * of_place);
        worst =
            std::accumulate(row + static_cast<std::ptrdiff_t>(low * of_place),
                            row + static_cast<std::ptrdiff_t>(high * of_place), worst,
                            [](const TaskFigures& a, const TaskFigures& b) { return worse(a, b); });
      }
      map.figures.push_back(worst);
    }
  }
  return map;
}

std::string summary(const RecordDesign& result) {
  const auto& [damper, figures] = result.nearest;
  std::string text = fmt::format("{}p = {:.6g}, f = {:.6g}, delta = {:.6g}",
                                 result.finding ? "" : "no damper: the nearest, ", damper.p,
                                 damper.f, damper.delta);
  for (const SuiteFigures& each : figures) {
    text +=
        each.settled
            ? fmt::format(", transmits {:.4g} g, moves up to |x| = {:.4g} and rests within {:.4g}",
                          each.acceleration, each.peak, each.residual)
            : ", does not come to rest";
  }
  return result.finding
             ? fmt::format("{} at the worst of {} dampers{}", text, result.finding->box.samples,
                           result.finding->cross_check.passed ? "" : "; the check failed")
             : text;
}

}  // namespace stillpoint::design
