// SPDX-License-Identifier: MIT
#include "step.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/trade_off.hpp>

#include <algorithm>
#include <cassert>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;
using enum Quantity;

/// A value that does not exist, and a time that never comes.
constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

void make_room(SweepBlock& block, std::span<const Quantity> quantities) {
  for (const Quantity quantity : quantities) {
    block[quantity].resize(block.size);
  }
}

/// `check` throws InputError for what is wrong with an entry.
void check_each(const SweepBlock& block, const std::function<void(Index)>& check) {
  for (Index i = 0; i < block.size; ++i) {
    try {
      check(i);
    } catch (const InputError&) {
      throw EntryError(i, std::current_exception());
    }
  }
}

/// How a sweep writes a figure of a motion.
double cell(double value, double /*missing*/) {
  return value;
}
double cell(const std::optional<double>& value, double missing) {
  return value.value_or(missing);
}
double cell(Outcome value, double /*missing*/) {
  return static_cast<double>(sweep_outcome(value));
}

/// Into those of `wanted` that the motion has.
template <class Result>
void set_motion(SweepBlock& block, Index i, const Result& motion,
                std::span<const Quantity> wanted) {
  for_each_field(motion_columns, [&]<class Member>(const MotionColumn<Member>& column) {
    if constexpr (requires { motion.*column.member; }) {
      if (contains(wanted, column.quantity)) {
        const bool never =
            column.missing == Missing::never && motion.outcome == Outcome::never_stops;
        block[column.quantity][i] = cell(motion.*column.member, never ? infinite : absent);
      }
    }
  });
}

void set_absent(SweepBlock& block, Index i, std::span<const Quantity> results) {
  for (const Quantity result : results) {
    block[result][i] = absent;
  }
}

/// The scaled record of an entry, made once for neighbours that share it: a copy can take half as
/// long as a motion that the notch soon locks.
class SharedLoad {
 public:
  [[nodiscard]] std::shared_ptr<const Excitation> of(const SweepSpec& spec, const SweepBlock& block,
                                                     Index i) {
    const std::pair wanted(block[record][i], block[record_scale][i]);
    {
      const std::scoped_lock lock(mutex_);
      if (load_ && made_for_ == wanted) {
        return load_;
      }
    }
    auto made = std::make_shared<const Excitation>(
        load_of(spec, [&](Quantity input) { return block[input][i]; }));
    const std::scoped_lock lock(mutex_);
    made_for_ = wanted;
    return load_ = std::move(made);
  }

 private:
  std::mutex mutex_;
  std::pair<double, double> made_for_;
  std::shared_ptr<const Excitation> load_;
};

/// The damper of an entry and the motion that is shown.
struct Designed {
  design::DesignPoint point;
  std::optional<std::int64_t> arrival;
  Response motion;
};

/// The best damper of all, or of the parts; empty if none is admissible.
std::optional<design::DesignPoint> point_of(const design::DesignRequest& request,
                                            const std::vector<design::Part>& parts) {
  const auto& [problem, limits, options, pulse, ranges] = request;
  std::optional<design::DesignPoint> point;
  if (parts.empty()) {
    if (const auto found = design::search(problem, limits, options)) {
      point = found->point;
    }
  } else if (const auto best = design::ranked(problem, limits, options.objective, parts).front();
             best.admissible) {
    point = {best.part.f, best.part.delta, best.tolerance.value_or(0)};
  }
  if (point) {  // its largest tolerance of f and Delta alike
    point->tolerance = even_tolerance(problem, limits, *point);
  }
  return point;
}

std::optional<Designed> designed_for_pulse(const design::DesignRequest& request,
                                           const std::vector<design::Part>& parts) {
  if (parts.empty()) {
    const auto found = design::damper(pulse_request(request));
    return found ? std::optional(Designed{found->point, {}, found->response}) : std::nullopt;
  }
  const auto result = choose(request, parts).result;
  if (!result.finding) {
    return std::nullopt;
  }
  const auto& [f, delta, tolerance] = result.finding->point;
  return Designed{{f, delta, design::even_tolerance(result)},
                  result.finding->arrival,
                  result.finding->pulse->response};
}

std::optional<Designed> designed(const design::Problem& problem,
                                 const std::optional<design::DesignPoint>& point,
                                 const FreeOptions& options) {
  if (!point) {
    return std::nullopt;
  }
  return Designed{*point, design::arrival_of(problem, point->f, point->delta),
                  free_response({.p = problem.p, .f = point->f, .delta = point->delta},
                                {.x0 = 0, .v0 = problem.v0}, options)};
}

/// Of a mass that is simulated. The largest tolerance is known only where it was searched.
std::optional<Designed> designed(const design::RecordDesignRequest& request,
                                 const std::function<bool()>& go_on) {
  const auto result =
      design::design(request, [&](const design::RecordProgress& /*progress*/) { return go_on(); });
  if (!result.finding) {
    return std::nullopt;
  }
  const design::SuiteDamper& damper = result.finding->point.damper;
  return Designed{{damper.f, damper.delta, result.largest_tolerance.value_or(absent)},
                  {},
                  result.finding->responses.front().front()};
}

}  // namespace

SweepStep::SweepStep(const SweepSpec& spec, std::stop_token stop)
    : spec_(spec),
      stop_(std::move(stop)),
      times_(contains(spec.columns, Quantity::stop_time)),
      acceleration_(contains(spec.columns, Quantity::peak_absolute_acceleration)),
      in_batches_(from_zero(spec) && plain_motion(spec) && !given(spec, Quantity::hold)),
      one_v0_and_p_(!varies(spec, Quantity::v0) && !varies(spec, Quantity::p)) {}

void SweepStep::operator()(SweepBlock& block) {
  require_ranges(block);
  if (spec_.units) {
    run_physical(block);
  } else {
    run(block);
  }
}

void SweepStep::require_ranges(const SweepBlock& block) const {
  for (const Quantity input : ranged_inputs) {
    if (const auto& others = block[*other_end(input)]; others.size() > 0) {
      check_each(block,
                 [&](Index i) { require_in_order(spec_, input, block[input][i], others[i]); });
    }
  }
}

/// The inputs of `block` are unchanged, whatever is thrown.
void SweepStep::run_physical(SweepBlock& block) {
  const SweepUnits& units = *spec_.units;
  plain_.size = block.size;
  plain_.first = block.first;
  for (const Quantity input : inputs(spec_.kind)) {
    plain_[input] =
        block[input].unaryExpr([&units, input](double value) { return units.plain(input, value); });
  }
  check_each(block, [&](Index i) {
    for (const Quantity input : inputs(spec_.kind)) {
      if (block[input].size() > 0) {
        require_in_units(spec_, input, block[input][i]);
      }
    }
  });
  run(plain_);
  for (const Quantity result : results(spec_.kind)) {
    block[result] = plain_[result] * units.unit(result);
  }
}

void SweepStep::run(SweepBlock& block) {
  switch (spec_.kind) {
    case SweepKind::free:
      return in_batches_ ? run_in_batches(block) : run_one_by_one(block);
    case SweepKind::forced:
      return run_one_by_one(block);
    case SweepKind::design:
      return run_design(block);
  }
  assert(false && "a SweepKind outside its enumeration");
}

/// An entry may take long itself; after a stop nobody reads its results.
void SweepStep::for_each(const SweepBlock& block, const std::function<void(Index)>& body) const {
  const auto go_on = [this] { return !stop_.stop_requested(); };
  for_each_entry(block.size, spec_.threads, go_on, [&](Index i) {
    const Cancellable cancellable(go_on);
    try {
      body(i);
    } catch (const Cancelled&) {
    }
  });
}

/// Of a motion with more half-cycles than the sweep allows nothing else is known.
void SweepStep::for_each_motion(SweepBlock& block, const std::function<void(Index)>& body) const {
  for_each(block, [&](Index i) {
    try {
      body(i);
    } catch (const TooManyHalfCycles&) {
      set_absent(block, i, results(spec_.kind));
      block[outcome][i] = static_cast<double>(too_many_half_cycles);
    }
  });
}

void SweepStep::run_in_batches(SweepBlock& block) {
  const BatchOptions options{
      .times = times_,
      .acceleration = acceleration_,
      .half_cycle_limit = spec_.half_cycle_limit.value_or(FreeOptions().half_cycle_limit),
      .threads = spec_.threads,
      .go_on = [this] { return !stop_.stop_requested(); }};
  try {
    if (one_v0_and_p_) {
      free_batch(block[v0][0], block[p][0], block[f], block[delta], options, batch_);
    } else {
      free_batch(block[v0], block[p], block[f], block[delta], options, batch_);
    }
  } catch (const InputError&) {
    return run_one_by_one(block);  // which says what is wrong with this entry
  } catch (const TooManyHalfCycles&) {
    return run_one_by_one(block);
  } catch (const Cancelled&) {
    return;  // after a stop nobody reads the results
  }
  block[peak_amplitude].swap(batch_.peak_amplitude);
  block[half_cycles].swap(batch_.half_cycles);
  block[stop_position].swap(batch_.stop_position);
  block[stop_time].swap(batch_.stop_time);
  block[peak_absolute_acceleration].swap(batch_.peak_absolute_acceleration);
  block[outcome].resize(block.size);
  for (Index i = 0; i < block.size; ++i) {
    block[outcome][i] = static_cast<double>(batch_.outcome[i]);
    if (batch_.outcome[i] == Outcome::never_stops) {
      block[stop_position][i] = absent;
    }
  }
}

void SweepStep::run_one_by_one(SweepBlock& block) const {
  make_room(block, results(spec_.kind));
  const bool free = spec_.kind == SweepKind::free;
  const FreeOptions by_map{
      .times = times_,
      .margin = false,
      .half_cycle_limit = spec_.half_cycle_limit.value_or(FreeOptions().half_cycle_limit)};
  const ForcedOptions followed{.t_end = spec_.t_end,
                               .half_cycle_limit = spec_.half_cycle_limit,
                               .go_on = [this](double /*tau*/) { return !stop_.stop_requested(); }};
  SharedLoad shared;
  for_each_motion(block, [&](Index i) {
    const auto [oscillator, start, surface] =
        motion_of(spec_, [&](Quantity input) { return block[input][i]; });
    if (free && surface.plain()) {
      return set_motion(block, i, free_response(oscillator, start, by_map), results(spec_.kind));
    }
    const auto load = spec_.records.empty() ? nullptr : shared.of(spec_, block, i);
    const Excitation& excitation = load ? *load : spec_.excitation;
    set_motion(
        block, i,
        forced_response(oscillator, start, free ? NoExcitation{} : excitation, followed, surface),
        results(spec_.kind));
  });
}

void SweepStep::run_design(SweepBlock& block) const {
  make_room(block, results(spec_.kind));
  const FreeOptions options{.times = times_, .margin = false};
  const bool front = given(spec_, trade_off);
  const std::int64_t dampers = dampers_of_each(spec_);
  const auto go_on = [this] { return !stop_.stop_requested(); };
  for_each(block, [&](Index i) {
    const auto at = [&](Quantity input) { return block[input][i]; };
    const auto request = request_of(spec_, at);
    const auto simulated = simulated_request(spec_, at);
    const auto damper = [&] {
      return front ? design::trade_off_at(request.problem, request.limits, dampers,
                                          static_cast<std::int64_t>(block[trade_off][i]))
                   : point_of(request, spec_.parts);
    };
    const auto found = simulated       ? designed(*simulated, go_on)
                       : request.pulse ? designed_for_pulse(request, spec_.parts)
                                       : designed(request.problem, damper(), options);
    block[feasible][i] = found ? 1 : 0;
    if (!found) {
      return set_absent(block, i, results(spec_.kind).subspan(1));
    }
    block[f][i] = found->point.f;
    block[delta][i] = found->point.delta;
    block[tolerance][i] = found->point.tolerance;
    block[arrival][i] = found->arrival ? static_cast<double>(*found->arrival) : absent;
    set_motion(block, i, found->motion, results(spec_.kind));
  });
}

}  // namespace stillpoint::sweep
