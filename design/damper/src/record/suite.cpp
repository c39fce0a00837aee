// SPDX-License-Identifier: MIT
#include "record/suite.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/record_batch.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <variant>

namespace stillpoint::design {

namespace {

/// For a damper that never rests: worse than any that does.
constexpr double never_rests = 1e9;

/// Dampers that a thread runs together: more fill the lanes of the kernel better, fewer busy all
/// threads.
constexpr std::size_t least_together = 32;
constexpr std::size_t most_together = 128;
constexpr std::size_t shares = 8;

Eigen::ArrayXd column(std::span<const SuiteDamper> dampers, double SuiteDamper::*member) {
  return Eigen::ArrayXd::NullaryExpr(std::ssize(dampers), [&](Eigen::Index i) {
    return dampers[static_cast<std::size_t>(i)].*member;
  });
}

}  // namespace

std::span<const Named<SuiteObjective>> enumerators(SuiteObjective) noexcept {
  static constexpr auto rows =
      std::to_array<Named<SuiteObjective>>({{SuiteObjective::acceleration, "acceleration"},
                                            {SuiteObjective::amplitude, "amplitude"},
                                            {SuiteObjective::residual, "residual"},
                                            {SuiteObjective::robust, "robust"},
                                            {SuiteObjective::time, "time"}});
  return rows;
}

std::span<const Named<Combine>> enumerators(Combine) noexcept {
  static constexpr auto rows =
      std::to_array<Named<Combine>>({{Combine::max, "max"}, {Combine::mean, "mean"}});
  return rows;
}

double peak_load(const SuiteRecord& record) {
  return std::abs(record.scale) * records::peak_acceleration(record.record);
}

double peak_load(const std::vector<SuiteRecord>& records) {
  double most = 0;
  for (const SuiteRecord& record : records) {
    most = std::max(most, peak_load(record));
  }
  return most;
}

std::string suite_words(Combine combine, std::size_t count) {
  return count == 1
             ? "Under the record"
             : fmt::format("{} of {} records", combine == Combine::max ? "Largest" : "Mean", count);
}

Record scaled(const SuiteRecord& record) {
  Record load = record.record;
  for (double& value : load.values) {
    value *= record.scale;
  }
  return load;
}

std::vector<CaseMotion> motions_of(const LoadCase& load_case) {
  std::vector<CaseMotion> list;
  for (const SuiteRecord& record : load_case.records) {
    list.push_back({record.name, record.scale, {}, {}, scaled(record)});
  }
  if (load_case.pulse) {
    list.push_back({std::string(name(*load_case.pulse)),
                    1,
                    {},
                    load_case.pulse,
                    excitation(*load_case.pulse)});
  } else if (load_case.v0) {
    list.push_back({"hit", 1, {0, *load_case.v0}, {}, NoExcitation{}});
  }
  return list;
}

double peak_load(const Excitation& load) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        if constexpr (std::is_same_v<Kind, Record>) {
          return records::peak_acceleration(kind);
        } else if constexpr (std::is_same_v<Kind, NoExcitation>) {
          return 0.0;
        } else {
          return std::abs(kind.k);
        }
      },
      load);
}

double peak_load(const LoadCase& load_case, double p) {
  return load_case.pulse ? peak_load(*load_case.pulse)
         : load_case.v0  ? p * *load_case.v0
                         : peak_load(load_case.records);
}

SimulationRequest motion_of(const RecordDesignRequest& request, const SuiteDamper& damper,
                            const CaseMotion& motion) {
  SimulationRequest simulation;
  simulation.oscillator = {damper.p, damper.f, damper.delta, request.hold};
  simulation.start = motion.start;
  simulation.surface.notch_width = damper.delta > 0 ? damper.notch_width() : std::nullopt;
  simulation.excitation = motion.load;
  return simulation;
}

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

const SuiteFigureKind& minimised(const RecordDesignRequest& request) {
  const auto* const found = std::ranges::find_if(suite_figure_kinds, [&](const auto& kind) {
    return request.objective == SuiteObjective::robust
               ? std::ranges::any_of(
                     request.cases,
                     [&](const LoadCase& each) { return (each.limits.*kind.limit).has_value(); })
               : kind.objective == request.objective;
  });
  return *found;
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

TaskFigures worse(const TaskFigures& one, const TaskFigures& other) {
  const bool longer = one.size() >= other.size();
  TaskFigures all = longer ? one : other;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    all[i] = worse(one[i], other[i]);
  }
  return all;
}

SuiteFigures largest(const TaskFigures& figures) {
  return std::accumulate(figures.begin(), figures.end(), SuiteFigures(),
                         [](const SuiteFigures& a, const SuiteFigures& b) { return worse(a, b); });
}

bool settled(const TaskFigures& figures) {
  return !figures.empty() && std::ranges::all_of(figures, &SuiteFigures::settled);
}

void require_valid(const std::vector<SuiteRecord>& records) {
  if (records.empty()) {
    throw InputError::missing("records", "give at least one");
  }
  for (const SuiteRecord& record : records) {
    require_within("scale", std::abs(record.scale), smallest_speed, largest_speed);
    require_valid(Excitation(record.record));
  }
}

std::vector<Excitation> scaled_loads(const std::vector<SuiteRecord>& records) {
  std::vector<Excitation> loads;
  loads.reserve(records.size());
  for (const SuiteRecord& record : records) {
    loads.emplace_back(scaled(record));
  }
  return loads;
}

namespace {

double part_of(double load, double own_weakest, double weakest) {
  return weakest < 1 ? 1 - (1 - load) * (1 - own_weakest) / (1 - weakest) : 1;
}

}  // namespace

double weakest_load(const RecordDesignRequest& request) {
  double least = 1;
  for (const LoadCase& each : request.cases) {
    least = std::min(least, each.weakest);
  }
  return std::max(least_weakest, least);
}

double load_part(const RecordDesignRequest& request, std::size_t in_case,
                 const SuiteDamper& damper) {
  return part_of(damper.load, std::max(least_weakest, request.cases[in_case].weakest),
                 weakest_load(request));
}

CaseMotion weakened(CaseMotion motion, double part) {
  motion.start.v0 *= part;
  std::visit(
      [part]<class Kind>(Kind& kind) {
        if constexpr (requires { kind.k; }) {
          kind.k *= part;
        }
      },
      motion.load);
  return motion;
}

SuiteDamper relative_to(const SuiteDamper& damper, double factor) {
  return {damper.p, damper.f / factor, damper.delta / (factor * factor), damper.width / factor,
          damper.load};
}

SuiteFigures times(SuiteFigures figures, double factor) {
  for (double* const figure :
       {&figures.peak, &figures.acceleration, &figures.residual, &figures.jump}) {
    *figure *= factor;
  }
  return figures;
}

Suite::Suite(const LoadCase& load_case, const std::optional<double>& hold, double weakest)
    : motions_(motions_of(load_case)),
      combine_(load_case.combine.value()),
      hold_(hold),
      own_weakest_(std::max(least_weakest, load_case.weakest)),
      weakest_(weakest) {}

double Suite::part(const SuiteDamper& damper) const {
  return part_of(damper.load, own_weakest_, weakest_);
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
  const auto add = [this](double& figure, double value) {
    figure = combine_ == Combine::max ? std::max(figure, value) : figure + value;
  };
  add(all.peak, one.peak);
  add(all.acceleration, one.acceleration);
  add(all.residual, one.residual);
  add(all.jump, one.jump);
  all.passages = std::max(all.passages, one.passages);
  all.stop_time = std::max(all.stop_time, one.stop_time);
  all.margin = std::min(all.margin, one.margin);
  all.late = std::max(all.late, one.late);
  all.settled = all.settled && one.settled;
}

double periods_after(const Excitation& load, double stop_time, double p) {
  const double after = std::max(0.0, stop_time - duration(load).value_or(0));
  return after * p / (2 * std::numbers::pi);
}

void Suite::combine(SuiteFigures& all) const {
  if (!all.settled) {
    all = SuiteFigures();
    all.settled = false;
  } else if (combine_ == Combine::mean) {
    const auto count = static_cast<double>(motions_.size());
    all.peak /= count;
    all.acceleration /= count;
    all.residual /= count;
    all.jump /= count;
  }
}

SuiteFigures Suite::under(const CaseMotion& motion, const SuiteDamper& damper) const {
  SuiteFigures figures;
  figures.settled = false;
  try {
    const double of_load = part(damper);
    const ForcedResponse one = response(damper, of_load < 1 ? weakened(motion, of_load) : motion);
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
  options.hold = hold_;
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
    cases_.emplace_back(each, request.hold, weakest_load(request));
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

std::vector<SuiteLimits> limits_of(const RecordDesignRequest& request) {
  std::vector<SuiteLimits> list;
  for (const LoadCase& each : request.cases) {
    list.push_back(each.limits);
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

double excess(const TaskFigures& figures, const std::vector<SuiteLimits>& limits) {
  double off = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    off += excess(figures[i], limits[i]);
  }
  return std::min(off, never_rests);
}

double use(const TaskFigures& figures, const std::vector<SuiteLimits>& limits) {
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

double SuiteGoal::value(const TaskFigures& figures) const {
  if (figure == nullptr) {
    return use(figures, limits);
  }
  double most = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    most = in_case.value_or(i) == i ? std::max(most, figures[i].*figure) : most;
  }
  return most;
}

SuiteRank rank(const TaskFigures& figures, const SuiteGoal& goal) {
  if (!figures.empty() && !settled(figures)) {
    return {never_rests, 0, 0};
  }
  return {excess(figures, goal.limits), goal.value(figures), largest(figures).peak};
}

bool admissible(const TaskFigures& figures, const std::vector<SuiteLimits>& limits) {
  return excess(figures, limits) == 0;
}

}  // namespace stillpoint::design
