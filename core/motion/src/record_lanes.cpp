// SPDX-License-Identifier: MIT

// Many motions under one record in lanes, docs/batch.md: each lane does the operations of
// RecordRun in kernel/record_run.hpp in their order, so that its values are those of the scalar
// kernel to the last bit. Not mirrored: changing the signs of all terms changes no rounding.
//
// | here    | meaning                                                                     |
// |---------|-----------------------------------------------------------------------------|
// | lane    | one motion                                                                  |
// | group   | the lanes of one vector                                                     |
// | calm    | nothing can happen to it from this sample to the next                       |
//
// Highway compiles this file once for each instruction set and picks one at run time.

#include "record_lanes.hpp"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "record_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "kernel/lane_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

namespace {

/// As in RecordRun: at these samples a is computed from y again.
constexpr std::size_t afresh = 16;

/// `damped`: with viscous damping.
template <bool damped>
class RecordGroup {
 public:
  RecordGroup(const double* record, const std::size_t* lanes, Index count, RecordColumns& columns,
              LaneEvents* const* events)
      : record_(record), lanes_(lanes), count_(count), columns_(columns), events_(events) {}

  HWY_INLINE void run(std::size_t i, std::size_t end) {
    load_all();
    while (true) {
      i = !any_rests_ ? advance<false>(i, end) : all_rest_ ? rest(i, end) : advance<true>(i, end);
      if (i == end) {
        break;
      }
      look_at_events(i);
      ++i;
    }
    store_all();
  }

 private:
  using Of = RecordValue;
  static constexpr double rests_for_ever = std::numeric_limits<double>::max();

  HWY_INLINE V get(RecordValue value) const {
    return at(numbers_[static_cast<std::size_t>(value)], 0);
  }
  HWY_INLINE void keep(V v, RecordValue value) {
    put(v, numbers_[static_cast<std::size_t>(value)], 0);
  }
  HWY_INLINE double& number(RecordValue value, Index k) {
    return numbers_[static_cast<std::size_t>(value)][k];
  }

  struct Point {
    V u;
    V v;
    V a;
  };

  // (F16)
  HWY_INLINE V next_v(const Point& s, V rise) const {
    return hn::Add(hn::Sub(s.v, hn::Mul(s.v, get(Of::versine))),
                   hn::Sub(hn::Mul(s.a, get(Of::sine)), hn::Mul(rise, get(Of::bend))));
  }

  HWY_INLINE V next_u(const Point& s, V rise) const {
    const V reach = get(damped ? Of::reach : Of::sine);
    const V moved = hn::Add(hn::Mul(s.v, reach), hn::Mul(s.a, get(Of::versine)));
    return hn::Add(s.u, hn::Sub(moved, hn::Mul(rise, get(Of::lag))));
  }

  HWY_INLINE V next_a(const Point& s, V rise) const {
    const V drag = get(damped ? Of::drag : Of::versine);
    return hn::Sub(hn::Sub(s.a, hn::Mul(s.a, drag)),
                   hn::Add(hn::Mul(s.v, get(Of::sine)), hn::Mul(rise, get(Of::pull))));
  }

  /// From u, v and w.
  HWY_INLINE V a_afresh(const Point& s, V phi, V w) const {
    const V force = hn::Add(hn::Add(s.u, phi), w);
    return hn::Neg(damped ? hn::Add(force, hn::Mul(get(Of::twice_zeta), s.v)) : force);
  }

  /// SlidePoint::may_feel_more: where the structure may feel more between two samples than before.
  /// `tilt` = fall times the rise of w.
  HWY_INLINE M may_feel_more(const Point& s, const Point& next, V w, V next_w, V tilt,
                             M slides) const {
    const V from = hn::Add(s.v, hn::Mul(get(Of::twice_zeta), s.a));
    const V to = hn::Add(next.v, hn::Mul(get(Of::twice_zeta), next.a));
    const V least = hn::Abs(tilt);
    const M monotone =
        hn::Or(hn::Gt(hn::Min(from, to), least), hn::Lt(hn::Max(from, to), hn::Neg(least)));
    const M turns = hn::AndNot(monotone, slides);
    if (hn::AllFalse(D(), turns)) [[likely]] {
      return turns;
    }
    const V ends = hn::Max(hn::Abs(hn::Add(s.a, w)), hn::Abs(hn::Add(next.a, next_w)));
    const V load = hn::Max(hn::Abs(w), hn::Abs(next_w));
    const V most = hn::Mul(get(Of::swell), hn::Add(ends, hn::Mul(get(Of::lift), load)));
    return hn::And(turns, hn::Gt(most, get(Of::felt)));
  }

  /// From sample i on while all lanes are calm; returns the sample before the interval where one is
  /// not. The calm ones are past the interval, and `next_` says where the others would be.
  template <bool rests>
  HWY_INLINE std::size_t advance(std::size_t i, std::size_t end) {
    const V inverse_p = get(Of::inverse_p);
    const V sign = get(Of::sign);
    const V mirror = hn::And(sign, hn::SignBit(D()));
    const V phi = get(Of::phi);
    const V look = get(Of::look);
    const M slides = hn::Ne(sign, hn::Zero(D()));
    Point now{get(Of::u), get(Of::v), get(Of::a)};
    V w = hn::Mul(all(record_[i]), inverse_p);
    for (; i < end; ++i) {
      const V next_w = hn::Mul(all(record_[i + 1]), inverse_p);
      const V rise = hn::Sub(next_w, w);
      Point next{next_u(now, rise), next_v(now, rise), now.a};
      // (F21)
      const V slower = hn::Min(hn::Xor(now.v, mirror), hn::Xor(next.v, mirror));
      const V tilt = hn::Mul(get(Of::fall), rise);
      const V least = hn::Max(get(Of::least_v), hn::Xor(tilt, mirror));
      M goes_on = hn::Gt(slower, least);
      M calm = hn::And(goes_on, hn::Lt(hn::Xor(next.u, mirror), look));
      if constexpr (rests) {
        const M held = goes_on_resting(now.u, w, next_w, hn::Not(slides));
        goes_on = hn::And(goes_on, slides);
        calm = hn::Or(hn::And(slides, calm), hn::AndNot(slides, held));
        next.u = hn::IfThenElse(slides, next.u, now.u);
        next.v = hn::IfThenElseZero(slides, next.v);
      }
      next.a = i % afresh == 0 ? a_afresh(next, phi, next_w) : next_a(now, rise);
      if constexpr (damped) {
        const M more = may_feel_more(now, next, w, next_w, tilt, slides);
        calm = hn::AndNot(more, calm);
        feels_more_ = bits(more);
      }
      if (!hn::AllTrue(D(), calm)) [[unlikely]] {
        stop(now, next, calm, goes_on);
        return i;
      }
      now = next;
      w = next_w;
    }
    keep(now.u, Of::u);
    keep(now.v, Of::v);
    keep(now.a, Of::a);
    return i;
  }

  HWY_INLINE void stop(const Point& now, const Point& next, M calm, M goes_on) {
    keep(hn::IfThenElse(calm, next.u, now.u), Of::u);
    keep(hn::IfThenElse(calm, next.v, now.v), Of::v);
    keep(hn::IfThenElse(calm, next.a, now.a), Of::a);
    put(next.u, next_u_, 0);
    put(next.v, next_v_, 0);
    put(next.a, next_a_, 0);
    waiting_ = bits(hn::Not(calm));
    goes_on_ = bits(goes_on);
  }

  /// The same where all lanes rest.
  HWY_INLINE std::size_t rest(std::size_t i, std::size_t end) {
    const V inverse_p = get(Of::inverse_p);
    const V u = get(Of::u);
    V w = hn::Mul(all(record_[i]), inverse_p);
    for (; i < end; ++i) {
      const V next_w = hn::Mul(all(record_[i + 1]), inverse_p);
      const M calm = goes_on_resting(u, w, next_w, hn::Eq(u, u));
      if (!hn::AllTrue(D(), calm)) [[unlikely]] {
        waiting_ = bits(hn::Not(calm));
        goes_on_ = 0;
        return i;
      }
      w = next_w;
    }
    return i;
  }

  /// RecordRun::rest_from: where the load w + u is held for certain at both ends.
  HWY_INLINE M goes_on_resting(V u, V w, V next_w, M rests) {
    const V zero = hn::Zero(D());
    const V certain = get(Of::certain);
    const V load = hn::Add(u, w);
    const V rise = hn::Sub(next_w, w);
    const V growth = hn::IfThenElse(hn::Gt(load, zero), rise, hn::Neg(rise));
    const M held = hn::Le(hn::Abs(hn::Add(u, next_w)), certain);
    const M crest =
        hn::And(hn::And(rests, hn::Le(growth, zero)), hn::Gt(hn::Abs(load), get(Of::crest)));
    if (hn::AllFalse(D(), crest)) {
      return held;
    }
    const M surely = hn::Le(hn::Abs(load), certain);
    decide_crest(u, w, load, hn::And(crest, surely));
    return hn::AndNot(hn::AndNot(surely, crest), held);
  }

  /// TippingMargin::decide with what the crest of a load lacks to friction.
  HWY_INLINE void decide_crest(V u, V w, V load, M crest) {
    const V phi = get(Of::phi);
    const V slack = hn::Abs(hn::Sub(hn::Abs(load), phi));
    const V scale = hn::Add(hn::Add(hn::Abs(u), hn::Abs(w)), phi);
    const M nearer =
        hn::And(crest, hn::Lt(hn::Mul(slack, get(Of::scale)), hn::Mul(get(Of::slack), scale)));
    keep(hn::IfThenElse(crest, hn::Abs(load), get(Of::crest)), Of::crest);
    keep(hn::IfThenElse(nearer, slack, get(Of::slack)), Of::slack);
    keep(hn::IfThenElse(nearer, scale, get(Of::scale)), Of::scale);
  }

  /// In the interval after sample i.
  HWY_INLINE void look_at_events(std::size_t i) {
    for (; waiting_ != 0; waiting_ &= waiting_ - 1) {
      const auto k = static_cast<Index>(__builtin_ctz(waiting_));
      const std::size_t lane = lanes_[k];
      const unsigned bit = waiting_ & (0 - waiting_);
      const double y = number(Of::sign, k) * next_u_[k];
      const bool passes = !damped || !(y < number(Of::look, k));
      if ((goes_on_ & bit) != 0 && y < number(Of::edge, k) &&
          (!passes || events_[lane]->passes())) {
        if (damped && (feels_more_ & bit) != 0) {
          events_[lane]->feels(i, {number(Of::u, k), number(Of::v, k), number(Of::a, k)},
                               {next_u_[k], next_v_[k], next_a_[k]});
          number(Of::felt, k) = columns_[Of::felt][lane];
        }
        number(Of::u, k) = next_u_[k];
        number(Of::v, k) = next_v_[k];
        number(Of::a, k) = next_a_[k];
        number(Of::look, k) = passes ? number(Of::edge, k) : number(Of::look, k);
      } else {
        store_state(k, lane);
        events_[lane]->through_interval(i);
        load(k, lane, Of::inverse_p);
      }
    }
    look_for_rests();
  }

  HWY_INLINE void look_for_rests() {
    const M rests = hn::Eq(get(Of::sign), hn::Zero(D()));
    any_rests_ = !hn::AllFalse(D(), rests);
    all_rest_ = hn::AllTrue(D(), rests);
  }

  HWY_INLINE void load_all() {
    for (Index k = 0; k < width; ++k) {
      if (k < count_) {
        load(k, lanes_[k], Of::count);
      } else {
        number(Of::certain, k) = number(Of::crest, k) = rests_for_ever;
      }
    }
    look_for_rests();
  }

  HWY_INLINE void load(Index k, std::size_t lane, RecordValue end) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(end); ++i) {
      numbers_[i][k] = columns_.numbers[i][lane];
    }
  }

  HWY_INLINE void store_all() {
    for (Index k = 0; k < count_; ++k) {
      store_state(k, lanes_[k]);
    }
  }

  HWY_INLINE void store_state(Index k, std::size_t lane) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(Of::scale); ++i) {
      columns_.numbers[i][lane] = numbers_[i][k];
    }
  }

  const double* record_;
  const std::size_t* lanes_;
  Index count_;
  RecordColumns& columns_;
  LaneEvents* const* events_;
  bool any_rests_{false};
  bool all_rest_{false};
  unsigned waiting_{0};  ///< those with an event
  unsigned goes_on_{0};  ///< of those that slide: v > 0 throughout
  unsigned feels_more_{0};

  std::array<Column<width>, static_cast<std::size_t>(Of::count)> numbers_{};
  Column<width> next_u_{};
  Column<width> next_v_{};
  Column<width> next_a_{};
};

template <bool damped>
void run_each_group(const double* record, std::size_t begin, std::size_t end,
                    const std::size_t* lanes, std::size_t count, RecordColumns& columns,
                    LaneEvents* const* events) {
  const auto all = static_cast<Index>(count);
  for (Index first = 0; first < all; first += width) {
    RecordGroup<damped>(record, lanes + first, all - first < width ? all - first : width, columns,
                        events)
        .run(begin, end);
  }
}

void run_groups(const double* record, std::size_t begin, std::size_t end, const std::size_t* lanes,
                std::size_t count, RecordColumns& columns, LaneEvents* const* events) {
  (columns.damped ? run_each_group<true> : run_each_group<false>)(record, begin, end, lanes, count,
                                                                  columns, events);
}

}  // namespace

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stillpoint {

namespace {
HWY_EXPORT(run_groups);
}  // namespace

void run_record_lanes(const double* record, std::size_t begin, std::size_t end,
                      const std::size_t* lanes, std::size_t count, RecordColumns& columns,
                      LaneEvents* const* events) {
  HWY_DYNAMIC_DISPATCH(run_groups)(record, begin, end, lanes, count, columns, events);
}

}  // namespace stillpoint
#endif
