// SPDX-License-Identifier: MIT
#pragma once

// A forced run under a record: docs/forced.md section 5. Most intervals between samples hold no
// event; there (F21) proves it from the values at both ends and the motion advances by nine
// multiplications with coefficients that depend on the interval alone. The others go through
// ForcedRun::through.

#include "kernel/forced_run.hpp"
#include "kernel/functions.hpp"
#include "kernel/record_samples.hpp"
#include "kernel/record_slide.hpp"

#include <stillpoint/core/excitation.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace stillpoint {

template <class Real, class Watcher, class Law>
class RecordRun {
 public:
  RecordRun(ForcedRun<Real, Watcher, Law>& run, const BasicRecord<Real>& record)
      : run_(run), samples_(record, run.map().p) {}

  /// Through the record, or until p tau = `end`; the load there.
  Load<Real> through(const ExactSum<Real>& end) {
    if (begin(end)) {
      finish(between_samples(), end);
    }
    return load_;
  }

  // One interval at a time: record_motion.hpp.

  /// Up to the first sample; whether any interval follows.
  [[gnu::noinline]] bool begin(const ExactSum<Real>& end) {
    before_first_sample(end);
    if (samples_.size() < 2 || !(end.minus(samples_.times().at(0)) > 0)) {
      return false;
    }
    decide_jump(run_, load_, samples_.load(0));
    last_ = samples_.times().latest(end);
    return true;
  }

  /// The last sample that is not after the end.
  [[nodiscard]] std::size_t last() const { return last_; }

  /// Through the whole interval after sample i, whatever happens in it.
  void through_interval(std::size_t i) {
    through_interval(i, ExactSum<Real>(samples_.times().length(i)));
  }

  /// From sample i to the end; the load there.
  Load<Real> finish(std::size_t i, const ExactSum<Real>& end) {
    to_end(i, end);
    run_.arrived(crossing_);
    return load_;
  }

  /// Whether the load at sample i holds the mass where it rests.
  template <class AnyHold>
  [[nodiscard]] bool held(std::size_t i, const AnyHold& hold) const {
    return held(i, hold, hold.held_for_certain());
  }

  /// Checks a crest of the load at sample i; `crest` is the largest load of this rest so far, since
  /// only a larger one can matter to the margin. Initially -1.
  template <class AnyHold>
  void look_at_crest(std::size_t i, const AnyHold& hold, Real& crest) {
    if (const Real size = magnitude(Real(hold.u() + samples_[i])); size > crest) {
      if (decide_held_crest(i, hold)) {
        crest = size;
      }
    }
  }

 private:
  using Run = ForcedRun<Real, Watcher, Law>;

  void before_first_sample(const ExactSum<Real>& end) {
    const ExactSum<Real> first = samples_.times().at(0);
    LinearDrive<Real> nothing;
    run_.through(nothing, end.minus(first) < 0 ? end : first, false);
  }

  std::size_t between_samples() {
    std::size_t i = 0;
    while (i < last_ && !run_.over() && run_.tick()) {
      i = run_.state().mode == ForcedMode::sliding ? slide_from(i) : rest_from(i, last_);
      if (i < last_) {
        through_interval(i);
        ++i;
      }
    }
    return i;
  }

  [[gnu::noinline]] void to_end(std::size_t i, const ExactSum<Real>& end) {
    if (run_.over()) {
      return;
    }
    run_.state().now = samples_.times().at(i);
    load_ = samples_.load(i);
    if (i + 1 < samples_.size()) {
      if (run_.state().mode == ForcedMode::resting) {
        decide_held_crest(i, run_.law().hold_at(run_.state().u));
      }
      const ExactSum<Real> length(end.minus(samples_.times().at(i)));
      through_interval(i, length);
      LinearDrive<Real> reached = samples_.drive_from(i);
      reached.advance(length.value());
      load_ = reached.load();
    }
  }

  void through_interval(std::size_t i, const ExactSum<Real>& length) {
    run_.state().now = samples_.times().at(i);
    const ForcedState<Real>& s = run_.state();
    const bool rested = s.mode == ForcedMode::resting;
    const Real before = s.u;
    const std::int64_t sticks = s.sticks;
    LinearDrive<Real> drive = samples_.drive_from(i);
    run_.through(drive, length, false, crossing_);
    if (s.sticks > sticks) {
      decide_crest(i, run_.law().hold_at(rested ? before : s.u));
    }
  }

  /// By how much the load eventually exceeds friction, after a release from sample i on.
  template <class AnyHold>
  void decide_crest(std::size_t i, const AnyHold& hold) {
    const int drives = hold.drives(samples_.load(i));
    const int sign = drives != 0 ? -drives : samples_[i + 1] > samples_[i] ? 1 : -1;
    const auto excess = [&](std::size_t at) {
      return Real(sign) * (samples_[at] + hold.u()) - hold.phi(sign);
    };
    const TippingMargin<Real>& margin = run_.state().margin;
    while (i + 1 < samples_.size() && excess(i + 1) > excess(i)) {
      ++i;
      if (!margin.matters(excess(i), hold.size(samples_[i]))) {
        return;  // nor does a larger one
      }
    }
    decide_hold(i, hold, sign);
  }

  /// How close the load came to what is held, at a sample where it was largest; returns whether it
  /// was.
  template <class AnyHold>
  bool decide_held_crest(std::size_t i, const AnyHold& hold) {
    const int sign = samples_[i] + hold.u() > 0 ? 1 : -1;
    const bool crest = Real(sign) * (samples_[i + 1] - samples_[i]) <= 0;
    if (crest) {
      decide_hold(i, hold, sign);
    }
    return crest;
  }

  template <class AnyHold>
  void decide_hold(std::size_t i, const AnyHold& hold, int sign) {
    const Real excess = hold.excess(samples_.load(i), sign);
    run_.state().margin.decide(magnitude(excess), hold.size(samples_[i]));
  }

  std::size_t slide_from(std::size_t i) {
    return samples_.times().even()
               ? slide_along<true>(run_, samples_, terms_, crossing_, i, last_)
               : slide_along<false>(run_, samples_, terms_, crossing_, i, last_);
  }

  /// On from sample i while the load at both ends of each interval, and so between, is held.
  std::size_t rest_from(std::size_t i, std::size_t last) {
    const ForcedState<Real>& s = run_.state();
    const auto hold = run_.law().hold_at(s.u);
    const Real certain = hold.held_for_certain();
    if (s.fresh || !held(i, hold, certain)) {
      return i;
    }
    constexpr std::size_t at_once = RecordSamples<Real>::at_once;
    Real crest{-1};
    while (i < last) {
      // Held throughout, and no crest there can matter.
      if (i + at_once <= last && samples_.largest_pull(i, hold.u()) <= std::min(crest, certain)) {
        i += at_once - 1;
        continue;
      }
      Real pull = hold.u() + samples_[i];
      for (const std::size_t end = std::min(i + at_once, last); i < end; ++i) {
        const Real next = hold.u() + samples_[i + 1];
        if (pull * (next - pull) <= 0 && magnitude(pull) > crest) {
          look_at_crest(i, hold, crest);
        }
        if (!held(i + 1, hold, certain)) {
          return i;
        }
        pull = next;
      }
    }
    return i;
  }

  template <class AnyHold>
  [[nodiscard]] bool held(std::size_t i, const AnyHold& hold, const Real& certain) const {
    return magnitude(Real(hold.u() + samples_[i])) <= certain || hold.drives(samples_.load(i)) == 0;
  }

  Run& run_;
  RecordSamples<Real> samples_;
  IntervalTerms<Real> terms_;
  using AnyCrossing = typename Run::template CrossingUnder<LinearDrive<Real>>;
  std::optional<AnyCrossing> crossing_;  ///< the last without a notch
  std::size_t last_{0};
  Load<Real> load_;  ///< at the end
};

}  // namespace stillpoint
