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
                                            {SuiteObjective::robust, "robust"}});
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

SimulationRequest motion_of(const RecordDesignRequest& request, const SuiteDamper& damper,
                            std::size_t record) {
  SimulationRequest motion;
  motion.oscillator = {damper.p, damper.f, damper.delta, request.hold};
  motion.start = {0, 0};
  motion.surface.notch_width = damper.delta > 0 ? damper.notch_width() : std::nullopt;
  motion.excitation = scaled(request.records[record]);
  return motion;
}

SuiteFigures suite_figures(const ForcedResponse& response) {
  const Figures figures = figures_of(response);
  return {figures.peak,
          figures.acceleration,
          figures.residual.value(),
          response.decision_margin.value_or(1),
          figures.jump,
          0,
          true};
}

const SuiteFigureKind& minimised(const RecordDesignRequest& request) {
  const auto* const found = std::ranges::find_if(suite_figure_kinds, [&](const auto& kind) {
    return request.objective == SuiteObjective::robust ? (request.limits.*kind.limit).has_value()
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
          one.settled && other.settled};
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

Suite::Suite(const RecordDesignRequest& request)
    : loads_(scaled_loads(request.records)),
      combine_(request.combine.value()),
      hold_(request.hold) {}

ForcedResponse Suite::response(const SuiteDamper& damper, const Excitation& load) const {
  return forced_response(oscillator(damper), {}, load, {.half_cycle_limit = most_suite_half_cycles},
                         surface(damper));
}

std::vector<ForcedResponse> Suite::responses(const SuiteDamper& damper) const {
  std::vector<ForcedResponse> list;
  list.reserve(loads_.size());
  for (const Excitation& load : loads_) {
    list.push_back(response(damper, load));
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
  all.margin = std::min(all.margin, one.margin);
  all.late = std::max(all.late, one.late);
  all.settled = all.settled && one.settled;
}

double periods_after(const Excitation& load, double stop_time, double p) {
  const double after = std::max(0.0, stop_time - duration(load).value());
  return after * p / (2 * std::numbers::pi);
}

void Suite::combine(SuiteFigures& all) const {
  if (!all.settled) {
    all = SuiteFigures();
    all.settled = false;
  } else if (combine_ == Combine::mean) {
    const auto count = static_cast<double>(loads_.size());
    all.peak /= count;
    all.acceleration /= count;
    all.residual /= count;
    all.jump /= count;
  }
}

SuiteFigures Suite::figures(const SuiteDamper& damper) const {
  SuiteFigures all;
  for (const Excitation& load : loads_) {
    try {
      const ForcedResponse one = response(damper, load);
      all.settled = one.stop_position && rests_in_time(one.half_cycles.value());
      if (all.settled) {
        SuiteFigures figures = suite_figures(one);
        figures.late = periods_after(load, one.stop_time.value(), damper.p);
        add(all, figures);
      }
    } catch (const TooManyHalfCycles&) {
      all.settled = false;
    }
    if (!all.settled) {
      break;
    }
  }
  combine(all);
  return all;
}

std::vector<SuiteFigures> Suite::under(const Excitation& load,
                                       std::span<const SuiteDamper> dampers) const {
  RecordBatchOptions options;
  options.hold = hold_;
  options.half_cycle_limit = most_suite_half_cycles;
  options.threads = 1;
  options.notch_width = column(dampers, &SuiteDamper::width);
  RecordBatchResult found;
  record_batch(0, column(dampers, &SuiteDamper::p), column(dampers, &SuiteDamper::f),
               column(dampers, &SuiteDamper::delta), std::get<Record>(load), options, found);
  std::vector<SuiteFigures> list(dampers.size());
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    list[k].settled = found.outcome[i] != Outcome::running &&
                      found.outcome[i] != Outcome::never_stops &&
                      rests_in_time(found.half_cycles[i]);
    if (list[k].settled) {
      list[k] = suite_figures(found.rest_of(i));
      list[k].late = periods_after(load, found.stop_time[i], dampers[k].p);
    }
  }
  return list;
}

/// One record after the other, each with the dampers that are left.
void Suite::run(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list) const {
  std::vector<SuiteDamper> left(dampers.begin(), dampers.end());
  std::vector<std::size_t> rows(dampers.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  for (std::size_t i = 0; i < loads_.size() && !left.empty(); ++i) {
    const std::vector<SuiteFigures> found = under(loads_[i], left);
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

/// All records at once, so that few dampers busy all threads.
void Suite::run_at_once(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list,
                        const Threads& threads) const {
  std::vector<std::vector<SuiteFigures>> found(loads_.size());
  for_each_entry(std::ssize(loads_), threads, {}, [&](std::ptrdiff_t i) {
    const auto load = static_cast<std::size_t>(i);
    found[load] = under(loads_[load], dampers);
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

double excess(const SuiteFigures& figures, const SuiteLimits& limits) {
  if (!figures.settled) {
    return never_rests;
  }
  double off = 0;
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& limit = limits.*kind.limit;
    const double value = figures.*kind.value;
    if (limit && value > *limit) {
      off += (value - *limit) / (*limit > 0 ? *limit : figures.peak);
    }
  }
  if (limits.late && figures.late > *limits.late) {
    off += figures.late / *limits.late - 1;
  }
  return std::min(off, never_rests);
}

double use(const SuiteFigures& figures, const SuiteLimits& limits) {
  double most = 0;
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& limit = limits.*kind.limit;
    if (limit && *limit > 0) {
      most = std::max(most, figures.*kind.value / *limit);
    }
  }
  return most;
}

SuiteRank rank(const SuiteFigures& figures, const SuiteGoal& goal) {
  return figures.settled
             ? SuiteRank{excess(figures, goal.limits),
                         goal.figure != nullptr ? figures.*goal.figure : use(figures, goal.limits),
                         figures.peak}
             : SuiteRank{never_rests, 0, 0};
}

bool admissible(const SuiteFigures& figures, const SuiteLimits& limits) {
  return excess(figures, limits) == 0;
}

}  // namespace stillpoint::design
