// SPDX-License-Identifier: MIT
#pragma once

// A forced run under a record: docs/forced.md section 5. Most intervals between samples hold no
// event; there (F21) proves it from the values at both ends and the motion advances by nine
// multiplications with coefficients that depend on the interval alone. The others go through
// ForcedRun::through.

#include "kernel/forced_run.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/record_intervals.hpp"

#include <stillpoint/core/excitation.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace stillpoint {

template <class Real, class Watcher, class Law>
class RecordRun {
 public:
  RecordRun(ForcedRun<Real, Watcher, Law>& run, const BasicRecord<Real>& record)
      : run_(run), record_(record), times_(record, run.map().p), inverse_p_(1 / run.map().p) {}

  /// Through the record, or until p tau = `end`; the load there.
  Load<Real> through(const ExactSum<Real>& end) {
    if (begin(end)) {
      finish(between_samples(), end);
    }
    return load_;
  }

  // One interval at a time: record_motion.hpp.

  /// Up to the first sample; whether any interval follows.
  bool begin(const ExactSum<Real>& end) {
    before_first_sample(end);
    if (record_.values.size() < 2 || !(end.minus(times_.at(0)) > 0)) {
      return false;
    }
    decide_jump(run_, load_, load(0));
    last_ = times_.latest(end);
    return true;
  }

  /// The last sample that is not after the end.
  [[nodiscard]] std::size_t last() const { return last_; }

  /// Through the whole interval after sample i, whatever happens in it.
  void through_interval(std::size_t i) { through_interval(i, ExactSum<Real>(times_.length(i))); }

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
    if (const Real size = Run::magnitude(Real(hold.u() + sample(i))); size > crest) {
      if (decide_held_crest(i, hold)) {
        crest = size;
      }
    }
  }

 private:
  using Run = ForcedRun<Real, Watcher, Law>;
  static constexpr std::size_t at_once = 8;  ///< samples of a rest

  void before_first_sample(const ExactSum<Real>& end) {
    const ExactSum<Real> first = times_.at(0);
    LinearDrive<Real> nothing;
    run_.through(nothing, end.minus(first) < 0 ? end : first, false);
  }

  std::size_t between_samples() {
    std::size_t i = 0;
    while (i < last_ && !run_.over() && run_.tick()) {
      i = run_.state().mode == ForcedMode::sliding ? slide_from(i, last_) : rest_from(i, last_);
      if (i < last_) {
        through_interval(i);
        ++i;
      }
    }
    return i;
  }

  void to_end(std::size_t i, const ExactSum<Real>& end) {
    if (run_.over()) {
      return;
    }
    run_.state().now = times_.at(i);
    load_ = load(i);
    if (i + 1 < record_.values.size()) {
      if (run_.state().mode == ForcedMode::resting) {
        decide_held_crest(i, run_.law().hold_at(run_.state().u));
      }
      const ExactSum<Real> length(end.minus(times_.at(i)));
      through_interval(i, length);
      LinearDrive<Real> reached = drive_from(i);
      reached.advance(length.value());
      load_ = reached.load();
    }
  }

  [[nodiscard]] Real sample(std::size_t i) const { return record_.values[i] * inverse_p_; }
  [[nodiscard]] Load<Real> load(std::size_t i) const {
    return {sample(i), ExactSum<Real>(record_.values[i])};
  }

  [[nodiscard]] LinearDrive<Real> drive_from(std::size_t i) const {
    return {sample(i), record_.values[i], sample(i + 1), record_.values[i + 1], times_.length(i)};
  }

  void through_interval(std::size_t i, const ExactSum<Real>& length) {
    run_.state().now = times_.at(i);
    const ForcedState<Real>& s = run_.state();
    const bool rested = s.mode == ForcedMode::resting;
    const Real before = s.u;
    const std::int64_t sticks = s.sticks;
    LinearDrive<Real> drive = drive_from(i);
    run_.through(drive, length, false, crossing_);
    if (s.sticks > sticks) {
      decide_crest(i, run_.law().hold_at(rested ? before : s.u));
    }
  }

  /// By how much the load eventually exceeds friction, after a release from sample i on.
  template <class AnyHold>
  void decide_crest(std::size_t i, const AnyHold& hold) {
    const int drives = hold.drives(load(i));
    const int sign = drives != 0 ? -drives : sample(i + 1) > sample(i) ? 1 : -1;
    const auto excess = [&](std::size_t at) {
      return Real(sign) * (sample(at) + hold.u()) - hold.phi(sign);
    };
    const TippingMargin<Real>& margin = run_.state().margin;
    while (i + 1 < record_.values.size() && excess(i + 1) > excess(i)) {
      ++i;
      if (!margin.matters(excess(i), hold.size(sample(i)))) {
        return;  // nor does a larger one
      }
    }
    decide_hold(i, hold, sign);
  }

  /// How close the load came to what is held, at a sample where it was largest; returns whether it
  /// was.
  template <class AnyHold>
  bool decide_held_crest(std::size_t i, const AnyHold& hold) {
    const int sign = sample(i) + hold.u() > 0 ? 1 : -1;
    const bool crest = Real(sign) * (sample(i + 1) - sample(i)) <= 0;
    if (crest) {
      decide_hold(i, hold, sign);
    }
    return crest;
  }

  template <class AnyHold>
  void decide_hold(std::size_t i, const AnyHold& hold, int sign) {
    const Real excess = hold.excess(load(i), sign);
    run_.state().margin.decide(Run::magnitude(excess), hold.size(sample(i)));
  }

  /// From sample i on while (F21) proves that no event comes; returns the first sample without such
  /// a proof, or a later one after a stretch that the hook should see.
  std::size_t slide_from(std::size_t i, std::size_t last) {
    return times_.even() ? slide_along<true>(i, last) : slide_along<false>(i, last);
  }

  template <bool even>
  [[gnu::noinline]] std::size_t slide_along(std::size_t i, std::size_t last) {
    constexpr std::size_t afresh = 16;
    ForcedState<Real>& s = run_.state();
    const Real sign(s.direction);
    const Real signed_inverse = sign * inverse_p_;
    const Real* const values = record_.values.data();
    Real y = sign * s.u;
    const Real phi = run_.law().phi_ahead(y);
    Real v = sign * s.v;
    Real w = values[i] * signed_inverse;
    Real a = -(y + phi + w);
    Real largest = s.acceleration;
    if (!(v > 0)) {
      return i;
    }
    Real arrival = run_.law().edge_ahead(y);
    const bool passes = !Law::in_zones && run_.map().notch == 0;
    take_terms(i);
    IntervalTerms<Real> t = terms_;  // a copy, which may stay in registers
    // An interval may hold the largest |a| only where |a| exceeds `matters` at one of its ends:
    // where it does so at `now`, any |a| at the other one will do.
    const auto threshold = [&](const Real& now) {
      const Real matters = largest * t.cosine;
      return Run::magnitude(now) > matters ? Real(-1) : matters;
    };
    Real matters = threshold(a);
    for (; i < last; ++i) {
      if constexpr (!even) {
        take_terms(i);
        t = terms_;
        matters = threshold(a);
      }
      const Real next_w = values[i + 1] * signed_inverse;
      const Real rise = next_w - w;
      const Real v_sine = v * t.sine;
      const Real a_versine = a * t.versine;
      const Real next_v = (v - v * t.versine) + (a * t.sine - rise * t.bend);
      const Real next_y = y + (v_sine + a_versine - rise * t.lag);
      if (!(std::min(v, next_v) > std::max(t.least_v, Real(t.fall * rise)))) {
        break;
      }
      // By (F16) a does not need y, so v and a wait only for each other. Now and then a is computed
      // from y again, so that rounding errors cannot make the two drift apart.
      const Real next_a = i % afresh == 0 ? Real(-(next_y + phi + next_w))
                                          : Real((a - a_versine) - (v_sine + rise * t.pull));
      const auto piece = [&] { return LinearPiece<Real>({y, v, a}, Real(rise / t.h)); };
      const auto end = [&] {
        return typename LinearPiece<Real>::End{PieceEvent::none, t.h, {next_y, next_v, next_a}};
      };
      if constexpr (Watcher::watches) {
        if (passes || next_y < arrival) {
          run_.watcher().piece(times_.at(i), s.direction, piece());
        }
      }
      if (next_y >= arrival) [[unlikely]] {
        if (!passes) {
          break;
        }
        arrival = std::numeric_limits<Real>::max();
        s.now = times_.at(i);
        run_.cross(piece(), end(), crossing_);
      }
      if (Run::magnitude(next_a) > matters) [[unlikely]] {
        largest = piece().largest_acceleration(end(), largest);
        matters = threshold(next_a);
      }
      y = next_y;
      v = next_v;
      a = next_a;
      w = next_w;
    }
    s.acceleration = largest;
    s.u = sign * y;
    s.v = sign * v;
    return i;
  }

  /// Those of the interval after sample i.
  void take_terms(std::size_t i) {
    if (const Real h = times_.length(i); h != terms_.h) {
      terms_ = IntervalTerms<Real>(h);
    }
  }

  /// On from sample i while the load at both ends of each interval, and so between, is held.
  std::size_t rest_from(std::size_t i, std::size_t last) {
    const ForcedState<Real>& s = run_.state();
    const auto hold = run_.law().hold_at(s.u);
    const Real certain = hold.held_for_certain();
    if (s.fresh || !held(i, hold, certain)) {
      return i;
    }
    Real crest{-1};
    while (i < last) {
      // Held throughout, and no crest there can matter.
      if (i + at_once <= last && largest_pull(i, hold.u()) <= std::min(crest, certain)) {
        i += at_once - 1;
        continue;
      }
      Real pull = hold.u() + sample(i);
      for (const std::size_t end = std::min(i + at_once, last); i < end; ++i) {
        const Real next = hold.u() + sample(i + 1);
        if (pull * (next - pull) <= 0 && Run::magnitude(pull) > crest) {
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

  /// The largest |w + u| at samples i to i + at_once - 1, in any order.
  [[nodiscard]] Real largest_pull(std::size_t i, const Real& u) const {
    std::array<Real, at_once / 2> most{};
    for (std::size_t k = 0; k < most.size(); ++k) {
      most[k] = std::max(Run::magnitude(Real(u + sample(i + k))),
                         Run::magnitude(Real(u + sample(i + most.size() + k))));
    }
    return *std::max_element(most.begin(), most.end());
  }

  template <class AnyHold>
  [[nodiscard]] bool held(std::size_t i, const AnyHold& hold, const Real& certain) const {
    return Run::magnitude(Real(hold.u() + sample(i))) <= certain || hold.drives(load(i)) == 0;
  }

  Run& run_;
  const BasicRecord<Real>& record_;
  RecordTimes<Real> times_;
  IntervalTerms<Real> terms_;
  std::optional<Crossing<LinearDrive<Real>, Real>> crossing_;  ///< the last without a notch
  Real inverse_p_;
  std::size_t last_{0};
  Load<Real> load_;  ///< at the end
};

/// The largest |W| from `from` until `until`, docs/forced.md (F30): at a sample, or at an end,
/// which may lie between two.
template <class Real>
Real largest_load(const BasicRecord<Real>& record, const Real& p, const ExactSum<Real>& from,
                  const ExactSum<Real>& until) {
  using std::abs;
  using std::max;
  const RecordTimes<Real> times(record, p);
  const ExactSum<Real> begin = from.minus(times.at(0)) < 0 ? times.at(0) : from;
  if (record.values.size() < 2 || !(until.minus(begin) > 0)) {
    return Real(0);
  }
  const auto load = [&](const ExactSum<Real>& when) {
    const std::size_t i = times.latest(when);
    if (i + 1 == record.values.size()) {
      return record.values[i];
    }
    const Real part = when.minus(times.at(i)) / times.length(i);
    return Real(record.values[i] + (record.values[i + 1] - record.values[i]) * part);
  };
  const Real largest = max(Real(abs(load(begin))), Real(abs(load(until))));
  std::array<Real, 8> most{};  // several, which do not wait for each other
  most.fill(largest);
  const std::size_t end = times.latest(until) + 1;
  std::size_t i = times.latest(begin) + 1;
  for (; i + most.size() <= end; i += most.size()) {
    for (std::size_t k = 0; k < most.size(); ++k) {
      most[k] = max(most[k], Real(abs(record.values[i + k])));
    }
  }
  for (; i < end; ++i) {
    most[0] = max(most[0], Real(abs(record.values[i])));
  }
  return *std::max_element(most.begin(), most.end());
}

}  // namespace stillpoint
