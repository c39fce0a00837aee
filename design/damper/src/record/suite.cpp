// SPDX-License-Identifier: MIT
#include "record/suite.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/record_batch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

namespace stillpoint::design {

namespace {

/// Dampers that a thread runs together: more fill the lanes of the kernel better, fewer busy all
/// threads.
constexpr std::size_t least_together = 32;
constexpr std::size_t most_together = 128;
constexpr std::size_t shares = 8;

Eigen::ArrayXd column(std::span<const SuiteDamper> dampers, const auto& of) {
  return Eigen::ArrayXd::NullaryExpr(std::ssize(dampers), [&](Eigen::Index i) {
    return std::invoke(of, dampers[static_cast<std::size_t>(i)]);
  });
}

}  // namespace

Suite::Suite(const LoadCase& load_case, const RecordDesignRequest& request)
    : motions_(motions_of(load_case)),
      combine_(load_case.combine.value()),
      of_all_{
          .cases = {}, .hold = request.hold, .zeta = request.zeta, .breakaway = request.breakaway},
      load_case_{.v0 = load_case.v0, .weakest = load_case.weakest},
      weakest_(weakest_load(request)) {}

double Suite::part(const SuiteDamper& damper) const {
  return load_part(damper.load, weakest_part(load_case_, damper), weakest_);
}

ForcedResponse Suite::response(const SuiteDamper& damper, const CaseMotion& motion) const {
  return forced_response(oscillator(damper), motion.start, motion.load,
                         {.half_cycle_limit = most_suite_half_cycles}, surface(damper));
}

std::vector<ForcedResponse> Suite::responses(const SuiteDamper& damper) const {
  std::vector<ForcedResponse> list;
  list.reserve(motions_.size());
  for (const CaseMotion& motion : motions_) {
    list.push_back(response(damper, motion));
  }
  return list;
}

void Suite::add(SuiteFigures& all, const SuiteFigures& one) const {
  const SuiteFigures before = std::exchange(all, worse(all, one));
  for (const auto figure : figures_of_load) {
    all.*figure = combine_ == Combine::max ? all.*figure : before.*figure + one.*figure;
  }
}

double periods_after(const Excitation& load, double stop_time, double p) {
  const double after = std::max(0.0, stop_time - duration(load).value_or(0));
  return after * p / (2 * std::numbers::pi);
}

void Suite::combine(SuiteFigures& all) const {
  for (const auto figure : figures_of_load) {
    all.*figure /= combine_ == Combine::mean ? static_cast<double>(motions_.size()) : 1;
  }
  all = all.settled ? all : unsettled;
}

/// A damped hit, whose half-cycles then need no pieces; the bits of others are those of a run.
bool Suite::moves_freely(const CaseMotion& motion, const SuiteDamper& damper) const {
  return std::holds_alternative<NoExcitation>(motion.load) && !damper.notch_width() &&
         oscillator(damper).zeta > 0;
}

SuiteFigures Suite::under(const CaseMotion& motion, const SuiteDamper& damper) const {
  SuiteFigures figures = unsettled;
  try {
    const double of_load = part(damper);
    const CaseMotion now = of_load < 1 ? weakened(motion, of_load) : motion;
    const ForcedResponse one =
        moves_freely(now, damper)
            ? ForcedResponse{free_response(oscillator(damper), now.start,
                                           {.half_cycle_limit = most_suite_half_cycles})}
            : response(damper, now);
    if (one.stop_position && rests_in_time(one.half_cycles.value())) {
      figures = suite_figures(one);
      figures.late = periods_after(motion.load, one.stop_time.value(), damper.p);
    }
  } catch (const TooManyHalfCycles&) {  // it does not settle
  }
  return figures;
}

std::size_t Suite::worst_motion(const SuiteDamper& damper, const SuiteFigureKind& kind) const {
  std::vector<double> values;
  for (const CaseMotion& motion : motions_) {
    values.push_back(under(motion, damper).*kind.value);
  }
  return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
}

SuiteFigures Suite::figures(const SuiteDamper& damper) const {
  SuiteFigures all;
  for (std::size_t i = 0; i < motions_.size() && all.settled; ++i) {
    add(all, under(motions_[i], damper));
  }
  combine(all);
  return all;
}

std::vector<SuiteFigures> Suite::under(const CaseMotion& motion,
                                       std::span<const SuiteDamper> dampers) const {
  std::vector<SuiteFigures> list(dampers.size());
  const Record* const record = std::get_if<Record>(&motion.load);
  if (record == nullptr) {
    std::ranges::transform(dampers, list.begin(),
                           [&](const SuiteDamper& damper) { return under(motion, damper); });
    return list;
  }
  RecordBatchOptions options;
  options.hold = of_all_.hold;
  options.breakaway = of_all_.breakaway;
  if (of_all_.zeta.high > 0) {
    options.zeta = column(dampers, [this](const auto& damper) { return oscillator(damper).zeta; });
  }
  options.half_cycle_limit = most_suite_half_cycles;
  options.threads = 1;
  options.notch_width = column(dampers, &SuiteDamper::width);
  RecordBatchResult found;
  record_batch(0, column(dampers, &SuiteDamper::p), column(dampers, &SuiteDamper::f),
               column(dampers, &SuiteDamper::delta), *record, options, found);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    list[k].settled = found.outcome[i] != Outcome::running &&
                      found.outcome[i] != Outcome::never_stops &&
                      rests_in_time(found.half_cycles[i]);
    if (list[k].settled) {
      list[k] = suite_figures(found.rest_of(i));
      list[k].late = periods_after(motion.load, found.stop_time[i], dampers[k].p);
    }
  }
  return list;
}

/// One motion after the other, each with the dampers that are left.
void Suite::run(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list) const {
  std::vector<SuiteDamper> left(dampers.begin(), dampers.end());
  std::vector<std::size_t> rows(dampers.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  for (std::size_t i = 0; i < motions_.size() && !left.empty(); ++i) {
    const std::vector<SuiteFigures> found = under(motions_[i], left);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < left.size(); ++k) {
      add(list[rows[k]], found[k]);
      if (found[k].settled) {
        left[kept] = left[k];
        rows[kept++] = rows[k];
      }
    }
    left.resize(kept);
  }
}

/// All motions at once, so that few dampers busy all threads.
void Suite::run_at_once(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list,
                        const Threads& threads) const {
  std::vector<std::vector<SuiteFigures>> found(motions_.size());
  for_each_entry(std::ssize(motions_), threads, {}, [&](std::ptrdiff_t i) {
    const auto motion = static_cast<std::size_t>(i);
    found[motion] = under(motions_[motion], dampers);
  });
  for (const std::vector<SuiteFigures>& of_one : found) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      add(list[k], of_one[k]);
    }
  }
}

std::vector<SuiteFigures> Suite::figures(std::span<const SuiteDamper> dampers,
                                         const Threads& threads) const {
  const std::size_t size = dampers.size();
  std::vector<SuiteFigures> list(size);
  if (size <= least_together) {
    run_at_once(dampers, list, threads);
  } else {
    const std::size_t lanes =
        (size / shares + least_together - 1) / least_together * least_together;
    const std::size_t together = std::clamp(lanes, least_together, most_together);
    const auto blocks = static_cast<std::ptrdiff_t>((size + together - 1) / together);
    for_each_entry(blocks, threads, {}, [&](std::ptrdiff_t block) {
      const std::size_t first = static_cast<std::size_t>(block) * together;
      const std::size_t count = std::min(together, size - first);
      run(dampers.subspan(first, count), std::span(list).subspan(first, count));
    });
  }
  for (SuiteFigures& all : list) {
    combine(all);
  }
  return list;
}

Suites::Suites(const RecordDesignRequest& request) {
  for (const LoadCase& each : request.cases) {
    cases_.emplace_back(each, request);
  }
}

TaskFigures Suites::figures(const SuiteDamper& damper) const {
  TaskFigures all;
  for (const Suite& each : cases_) {
    all.push_back(each.figures(damper));
  }
  return all;
}

std::vector<TaskFigures> Suites::figures(std::span<const SuiteDamper> dampers,
                                         const Threads& threads) const {
  std::vector<TaskFigures> list(dampers.size());
  for (const Suite& each : cases_) {
    const std::vector<SuiteFigures> of_case = each.figures(dampers, threads);
    for (std::size_t i = 0; i < list.size(); ++i) {
      list[i].push_back(of_case[i]);
    }
  }
  return list;
}

}  // namespace stillpoint::design
