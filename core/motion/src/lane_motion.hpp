// SPDX-License-Identifier: MIT
#pragma once

// One motion of the record batch: between events its lane moves it, record_lanes.cpp, and here it
// meets them by the rules of the scalar kernel, in the order of RecordRun.

#include "kernel/record_run.hpp"
#include "record_motion.hpp"
#include "response_of_run.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace stillpoint {

template <class Law>
class LaneMotion final : public RecordMotion {
 public:
  /// `bare`: the oscillator without what the law takes over.
  LaneMotion(const LaneTask& task, const Oscillator& bare, Law law)
      : oscillator_(task.oscillator),
        options_(task.options),
        record_(std::get<Record>(task.excitation)),
        end_(duration(task.excitation).value()),
        columns_(task.columns),
        lane_(task.lane),
        run_(bare, std::move(law), task.start, nobody_),
        record_run_(run_, record_) {
    prepare(run_, task.oscillator, task.excitation, task.options);
  }

  bool begin() override {
    begun_ = !run_.over() && record_run_.begin(reach());
    if (begun_) {
      set_terms();
      enter(0);
    }
    return begun_;
  }

  [[nodiscard]] std::size_t last() const override { return record_run_.last(); }

  [[nodiscard]] bool over() const override { return run_.over(); }

  bool passes() override {
    return unless_too_many([&] { run_.pass(); });
  }

  void feels(std::size_t i, const LanePoint& from, const LanePoint& to) override {
    if constexpr (Law::damped) {
      const double sign = columns_.sign[lane_];
      const auto point = [&](std::size_t sample, const LanePoint& at) {
        const double w = record_.values[sample] * columns_.inverse_p[lane_];
        return SlidePoint<double, true>{sign * at.u, sign * at.v, sign * at.a, sign * w};
      };
      double& felt = run_.state().transmitted.slid;
      point(i, from).feel(point(i + 1, to), terms_, sign * columns_.phi[lane_], felt);
      columns_.felt[lane_] = felt;
    }
  }

  void through_interval(std::size_t i) override {
    if (!run_.over() && !goes_on_resting(i) &&
        unless_too_many([&] { record_run_.through_interval(i); })) {
      enter(i + 1);
    }
  }

  [[nodiscard]] std::optional<ForcedResponse> response() override {
    std::optional<ForcedResponse> found;
    leave();
    if (!too_many_) {
      unless_too_many([&] {
        const Load<double> load = begun_ ? record_run_.finish(last(), reach()) : Load<double>();
        to_free_turn(run_, load);
        found = response_to(run_, end_, oscillator_, options_);
      });
    }
    return found;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  [[nodiscard]] ExactSum<double> reach() const {
    return ExactSum<double>::product(run_.map().p, end_);
  }

  template <class Action>
  bool unless_too_many(const Action& action) {
    try {
      action();
    } catch (const TooManyHalfCycles&) {
      too_many_ = true;
      run_.state().mode = ForcedMode::over;
      enter(0);
    }
    return !too_many_;
  }

  void set_terms() {
    update(terms_, run_.map().p * record_.step, run_.law());
    const IntervalTerms<double>& terms = terms_;
    columns_.inverse_p[lane_] = 1 / run_.map().p;
    columns_.sine[lane_] = terms.sine;
    columns_.versine[lane_] = terms.versine;
    columns_.lag[lane_] = terms.lag;
    columns_.bend[lane_] = terms.bend;
    columns_.pull[lane_] = terms.pull;
    columns_.fall[lane_] = terms.fall;
    columns_.least_v[lane_] = terms.least_v;
    columns_.reach[lane_] = terms.reach;
    columns_.drag[lane_] = terms.drag;
    columns_.twice_zeta[lane_] = terms.twice_zeta;
    columns_.swell[lane_] = terms.swell;
    columns_.lift[lane_] = terms.lift;
  }

  /// Gives the state at sample i to the lane.
  void enter(std::size_t i) {
    constexpr double never = std::numeric_limits<double>::max();
    const ForcedState<double>& s = run_.state();
    const bool slides = s.mode == ForcedMode::sliding;
    const double sign = slides ? s.direction : 0;
    const double y = sign * s.u;
    columns_.u[lane_] = s.u;
    columns_.v[lane_] = s.v;
    columns_.a[lane_] = 0;
    columns_.sign[lane_] = sign;
    columns_.phi[lane_] = sign * run_.law().phi_ahead(y);
    columns_.edge[lane_] = run_.law().edge_ahead(y);
    columns_.look[lane_] = y < 0 ? std::min(columns_.edge[lane_], 0.0) : columns_.edge[lane_];
    columns_.certain[lane_] = columns_.crest[lane_] = never;  // for a motion that has ended
    if (slides) {
      const double w = record_.values[i] * columns_.inverse_p[lane_];
      double force = s.u + columns_.phi[lane_] + w;
      if constexpr (Law::damped) {
        force += run_.law().drag(s.v);
      }
      columns_.a[lane_] = -force;
      columns_.felt[lane_] = s.transmitted.slid;
    } else if (!run_.over()) {
      const auto hold = run_.law().hold_at(s.u);
      decided_ = !s.fresh && record_run_.held(i, hold);
      columns_.certain[lane_] = decided_ ? hold.held_for_certain() : -1;
      columns_.crest[lane_] = -1;
      columns_.phi[lane_] = hold.phi(1);  // or (-1): at an edge the margin is 0 anyway
      give_margin();
    }
  }

  void give_margin() {
    const TippingMargin<double>& margin = run_.state().margin;
    columns_.slack[lane_] = infinite;
    columns_.scale[lane_] = 1;
    if (margin.any()) {
      columns_.slack[lane_] = margin.slack();
      columns_.scale[lane_] = margin.scale();
    }
  }

  /// Takes the state back from the lane.
  void leave() {
    ForcedState<double>& s = run_.state();
    if (begun_ && s.mode == ForcedMode::sliding) {
      s.u = columns_.u[lane_];
      s.v = columns_.v[lane_];
    } else if (begun_ && s.mode == ForcedMode::resting && columns_.slack[lane_] < infinite) {
      s.margin = {columns_.slack[lane_], columns_.scale[lane_]};
    }
  }

  /// As RecordRun::rest_from.
  bool goes_on_resting(std::size_t i) {
    leave();
    if (run_.state().mode != ForcedMode::resting || !decided_) {
      return false;
    }
    const auto hold = run_.law().hold_at(run_.state().u);
    record_run_.look_at_crest(i, hold, columns_.crest[lane_]);
    give_margin();
    return record_run_.held(i + 1, hold);
  }

  Oscillator oscillator_;
  const ForcedOptions& options_;
  const Record& record_;
  double end_;
  RecordColumns& columns_;
  std::size_t lane_;
  NoWatcher nobody_;
  ForcedRun<double, NoWatcher, Law> run_;
  RecordRun<double, NoWatcher, Law> record_run_;
  IntervalTerms<double> terms_;
  bool begun_{false};
  bool decided_{false};  ///< at rest: the load there is known to hold it
  bool too_many_{false};
};

}  // namespace stillpoint
