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
      const double sign = my(Of::sign);
      const auto point = [&](std::size_t sample, const LanePoint& at) {
        const double w = record_.values[sample] * my(Of::inverse_p);
        return SlidePoint<double, true>{sign * at.u, sign * at.v, sign * at.a, sign * w};
      };
      double& felt = run_.state().transmitted.slid;
      point(i, from).feel(point(i + 1, to), terms_, sign * my(Of::phi), felt);
      my(Of::felt) = felt;
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

  using Of = RecordValue;

  [[nodiscard]] double& my(RecordValue value) { return columns_[value][lane_]; }

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
    const IntervalTerms<double>& t = terms_;
    my(Of::inverse_p) = 1 / run_.map().p;
    auto value = static_cast<std::size_t>(Of::sine);
    for (const double term : {t.sine, t.versine, t.lag, t.bend, t.pull, t.fall, t.least_v, t.reach,
                              t.drag, t.twice_zeta, t.swell, t.lift}) {
      columns_.numbers[value++][lane_] = term;
    }
  }

  /// Gives the state at sample i to the lane.
  void enter(std::size_t i) {
    constexpr double never = std::numeric_limits<double>::max();
    const ForcedState<double>& s = run_.state();
    const bool slides = s.mode == ForcedMode::sliding;
    const double sign = slides ? s.direction : 0;
    const double y = sign * s.u;
    my(Of::u) = s.u;
    my(Of::v) = s.v;
    my(Of::a) = 0;
    my(Of::sign) = sign;
    my(Of::phi) = sign * run_.law().phi_ahead(y);
    my(Of::edge) = run_.law().edge_ahead(y);
    my(Of::look) = y < 0 ? std::min(my(Of::edge), 0.0) : my(Of::edge);
    my(Of::certain) = my(Of::crest) = never;  // for a motion that has ended
    if (slides) {
      const double w = record_.values[i] * my(Of::inverse_p);
      double force = s.u + my(Of::phi) + w;
      if constexpr (Law::damped) {
        force += run_.law().drag(s.v);
      }
      my(Of::a) = -force;
      my(Of::felt) = s.transmitted.slid;
    } else if (!run_.over()) {
      const auto hold = run_.law().hold_at(s.u);
      decided_ = !s.fresh && record_run_.held(i, hold);
      my(Of::certain) = decided_ ? hold.held_for_certain() : -1;
      my(Of::crest) = -1;
      my(Of::phi) = hold.phi(1);  // or (-1): at an edge the margin is 0 anyway
      give_margin();
    }
  }

  void give_margin() {
    const TippingMargin<double>& margin = run_.state().margin;
    my(Of::slack) = infinite;
    my(Of::scale) = 1;
    if (margin.any()) {
      my(Of::slack) = margin.slack();
      my(Of::scale) = margin.scale();
    }
  }

  /// Takes the state back from the lane.
  void leave() {
    ForcedState<double>& s = run_.state();
    if (begun_ && s.mode == ForcedMode::sliding) {
      s.u = my(Of::u);
      s.v = my(Of::v);
    } else if (begun_ && s.mode == ForcedMode::resting && my(Of::slack) < infinite) {
      s.margin = {my(Of::slack), my(Of::scale)};
    }
  }

  /// As RecordRun::rest_from.
  bool goes_on_resting(std::size_t i) {
    leave();
    if (run_.state().mode != ForcedMode::resting || !decided_) {
      return false;
    }
    const auto hold = run_.law().hold_at(run_.state().u);
    record_run_.look_at_crest(i, hold, my(Of::crest));
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
