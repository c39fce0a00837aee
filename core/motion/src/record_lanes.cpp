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
  /// (F16) and (F21) over an interval.
  struct Terms {
    V sine;
    V versine;
    V lag;
    V bend;
    V pull;
    V fall;
    V least_v;
    V reach;
    V drag;
    V twice_zeta;
  };

  struct Point {
    V u;
    V v;
    V a;
  };

  HWY_INLINE Terms terms() const {
    return {at(sine_, 0), at(versine_, 0), at(lag_, 0),   at(bend_, 0), at(pull_, 0),
            at(fall_, 0), at(least_v_, 0), at(reach_, 0), at(drag_, 0), at(twice_zeta_, 0)};
  }

  static HWY_INLINE V next_v(const Terms& t, const Point& s, V rise) {
    return hn::Add(hn::Sub(s.v, hn::Mul(s.v, t.versine)),
                   hn::Sub(hn::Mul(s.a, t.sine), hn::Mul(rise, t.bend)));
  }

  static HWY_INLINE V next_u(const Terms& t, const Point& s, V rise) {
    const V reach = damped ? t.reach : t.sine;
    const V moved = hn::Add(hn::Mul(s.v, reach), hn::Mul(s.a, t.versine));
    return hn::Add(s.u, hn::Sub(moved, hn::Mul(rise, t.lag)));
  }

  static HWY_INLINE V next_a(const Terms& t, const Point& s, V rise) {
    const V drag = damped ? t.drag : t.versine;
    return hn::Sub(hn::Sub(s.a, hn::Mul(s.a, drag)),
                   hn::Add(hn::Mul(s.v, t.sine), hn::Mul(rise, t.pull)));
  }

  /// From u, v and w.
  static HWY_INLINE V a_afresh(const Terms& t, const Point& s, V phi, V w) {
    const V force = hn::Add(hn::Add(s.u, phi), w);
    return hn::Neg(damped ? hn::Add(force, hn::Mul(t.twice_zeta, s.v)) : force);
  }

  /// SlidePoint::may_feel_more: where the structure may feel more between two samples than before.
  /// `tilt` = fall times the rise of w.
  HWY_INLINE M may_feel_more(const Terms& t, const Point& s, const Point& next, V w, V next_w,
                             V tilt, M slides) const {
    const V from = hn::Add(s.v, hn::Mul(t.twice_zeta, s.a));
    const V to = hn::Add(next.v, hn::Mul(t.twice_zeta, next.a));
    const V least = hn::Abs(tilt);
    const M monotone =
        hn::Or(hn::Gt(hn::Min(from, to), least), hn::Lt(hn::Max(from, to), hn::Neg(least)));
    const M turns = hn::AndNot(monotone, slides);
    if (hn::AllFalse(D(), turns)) [[likely]] {
      return turns;
    }
    const V ends = hn::Max(hn::Abs(hn::Add(s.a, w)), hn::Abs(hn::Add(next.a, next_w)));
    const V load = hn::Max(hn::Abs(w), hn::Abs(next_w));
    const V most = hn::Mul(at(swell_, 0), hn::Add(ends, hn::Mul(at(lift_, 0), load)));
    return hn::And(turns, hn::Gt(most, at(felt_, 0)));
  }

  /// From sample i on while all lanes are calm; returns the sample before the interval where one is
  /// not. The calm ones are past the interval, and `next_` says where the others would be.
  template <bool rests>
  HWY_INLINE std::size_t advance(std::size_t i, std::size_t end) {
    const V inverse_p = at(inverse_p_, 0);
    const Terms t = terms();
    const V sign = at(sign_, 0);
    const V mirror = hn::And(sign, hn::SignBit(D()));
    const V phi = at(phi_, 0);
    const V look = at(look_, 0);
    const M slides = hn::Ne(sign, hn::Zero(D()));
    Point now{at(u_, 0), at(v_, 0), at(a_, 0)};
    V w = hn::Mul(all(record_[i]), inverse_p);
    for (; i < end; ++i) {
      const V next_w = hn::Mul(all(record_[i + 1]), inverse_p);
      const V rise = hn::Sub(next_w, w);
      Point next{next_u(t, now, rise), next_v(t, now, rise), now.a};
      // (F21)
      const V slower = hn::Min(hn::Xor(now.v, mirror), hn::Xor(next.v, mirror));
      const V tilt = hn::Mul(t.fall, rise);
      const V least = hn::Max(t.least_v, hn::Xor(tilt, mirror));
      M goes_on = hn::Gt(slower, least);
      M calm = hn::And(goes_on, hn::Lt(hn::Xor(next.u, mirror), look));
      if constexpr (rests) {
        const M held = goes_on_resting(now.u, w, next_w, hn::Not(slides));
        goes_on = hn::And(goes_on, slides);
        calm = hn::Or(hn::And(slides, calm), hn::AndNot(slides, held));
        next.u = hn::IfThenElse(slides, next.u, now.u);
        next.v = hn::IfThenElseZero(slides, next.v);
      }
      next.a = i % afresh == 0 ? a_afresh(t, next, phi, next_w) : next_a(t, now, rise);
      if constexpr (damped) {
        const M more = may_feel_more(t, now, next, w, next_w, tilt, slides);
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
    put(now.u, u_, 0);
    put(now.v, v_, 0);
    put(now.a, a_, 0);
    return i;
  }

  HWY_INLINE void stop(const Point& now, const Point& next, M calm, M goes_on) {
    put(hn::IfThenElse(calm, next.u, now.u), u_, 0);
    put(hn::IfThenElse(calm, next.v, now.v), v_, 0);
    put(hn::IfThenElse(calm, next.a, now.a), a_, 0);
    put(next.u, next_u_, 0);
    put(next.v, next_v_, 0);
    put(next.a, next_a_, 0);
    waiting_ = bits(hn::Not(calm));
    goes_on_ = bits(goes_on);
  }

  /// The same where all lanes rest.
  HWY_INLINE std::size_t rest(std::size_t i, std::size_t end) {
    const V inverse_p = at(inverse_p_, 0);
    const V u = at(u_, 0);
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
    const V certain = at(certain_, 0);
    const V load = hn::Add(u, w);
    const V rise = hn::Sub(next_w, w);
    const V growth = hn::IfThenElse(hn::Gt(load, zero), rise, hn::Neg(rise));
    const M held = hn::Le(hn::Abs(hn::Add(u, next_w)), certain);
    const M crest =
        hn::And(hn::And(rests, hn::Le(growth, zero)), hn::Gt(hn::Abs(load), at(crest_, 0)));
    if (hn::AllFalse(D(), crest)) {
      return held;
    }
    const M surely = hn::Le(hn::Abs(load), certain);
    decide_crest(u, w, load, hn::And(crest, surely));
    return hn::AndNot(hn::AndNot(surely, crest), held);
  }

  /// TippingMargin::decide with what the crest of a load lacks to friction.
  HWY_INLINE void decide_crest(V u, V w, V load, M crest) {
    const V phi = at(phi_, 0);
    const V slack = hn::Abs(hn::Sub(hn::Abs(load), phi));
    const V scale = hn::Add(hn::Add(hn::Abs(u), hn::Abs(w)), phi);
    const M nearer =
        hn::And(crest, hn::Lt(hn::Mul(slack, at(scale_, 0)), hn::Mul(at(slack_, 0), scale)));
    put(hn::IfThenElse(crest, hn::Abs(load), at(crest_, 0)), crest_, 0);
    put(hn::IfThenElse(nearer, slack, at(slack_, 0)), slack_, 0);
    put(hn::IfThenElse(nearer, scale, at(scale_, 0)), scale_, 0);
  }

  /// In the interval after sample i.
  HWY_INLINE void look_at_events(std::size_t i) {
    for (; waiting_ != 0; waiting_ &= waiting_ - 1) {
      const auto k = static_cast<Index>(__builtin_ctz(waiting_));
      const std::size_t lane = lanes_[k];
      const unsigned bit = waiting_ & (0 - waiting_);
      const double y = sign_[k] * next_u_[k];
      const bool passes = !damped || !(y < look_[k]);
      if ((goes_on_ & bit) != 0 && y < edge_[k] && (!passes || events_[lane]->passes())) {
        if (damped && (feels_more_ & bit) != 0) {
          events_[lane]->feels(i, {u_[k], v_[k], a_[k]}, {next_u_[k], next_v_[k], next_a_[k]});
          felt_[k] = columns_.felt[lane];
        }
        u_[k] = next_u_[k];
        v_[k] = next_v_[k];
        a_[k] = next_a_[k];
        look_[k] = passes ? edge_[k] : look_[k];
      } else {
        store_state(k, lane);
        events_[lane]->through_interval(i);
        load_state(k, lane);
      }
    }
    look_for_rests();
  }

  HWY_INLINE void look_for_rests() {
    const M rests = hn::Eq(at(sign_, 0), hn::Zero(D()));
    any_rests_ = !hn::AllFalse(D(), rests);
    all_rest_ = hn::AllTrue(D(), rests);
  }

  HWY_INLINE void load_all() {
    for (Index k = 0; k < width; ++k) {
      if (k < count_) {
        const std::size_t lane = lanes_[k];
        load_state(k, lane);
        inverse_p_[k] = columns_.inverse_p[lane];
        sine_[k] = columns_.sine[lane];
        versine_[k] = columns_.versine[lane];
        lag_[k] = columns_.lag[lane];
        bend_[k] = columns_.bend[lane];
        pull_[k] = columns_.pull[lane];
        fall_[k] = columns_.fall[lane];
        least_v_[k] = columns_.least_v[lane];
        reach_[k] = columns_.reach[lane];
        drag_[k] = columns_.drag[lane];
        twice_zeta_[k] = columns_.twice_zeta[lane];
        swell_[k] = columns_.swell[lane];
        lift_[k] = columns_.lift[lane];
      } else {
        certain_[k] = crest_[k] = std::numeric_limits<double>::max();  // rests for ever
      }
    }
    look_for_rests();
  }

  HWY_INLINE void load_state(Index k, std::size_t lane) {
    u_[k] = columns_.u[lane];
    v_[k] = columns_.v[lane];
    a_[k] = columns_.a[lane];
    sign_[k] = columns_.sign[lane];
    phi_[k] = columns_.phi[lane];
    look_[k] = columns_.look[lane];
    edge_[k] = columns_.edge[lane];
    certain_[k] = columns_.certain[lane];
    crest_[k] = columns_.crest[lane];
    slack_[k] = columns_.slack[lane];
    scale_[k] = columns_.scale[lane];
    felt_[k] = columns_.felt[lane];
  }

  HWY_INLINE void store_all() {
    for (Index k = 0; k < count_; ++k) {
      store_state(k, lanes_[k]);
    }
  }

  HWY_INLINE void store_state(Index k, std::size_t lane) {
    columns_.u[lane] = u_[k];
    columns_.v[lane] = v_[k];
    columns_.a[lane] = a_[k];
    columns_.look[lane] = look_[k];
    columns_.crest[lane] = crest_[k];
    columns_.slack[lane] = slack_[k];
    columns_.scale[lane] = scale_[k];
  }

  static HWY_INLINE unsigned bits(M mask) {
    std::array<std::uint8_t, 8> number{};
    hn::StoreMaskBits(D(), mask, number.data());
    return number[0];
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

  Column<width> u_{};
  Column<width> v_{};
  Column<width> a_{};
  Column<width> sign_{};
  Column<width> phi_{};
  Column<width> look_{};
  Column<width> edge_{};
  Column<width> certain_{};
  Column<width> crest_{};
  Column<width> slack_{};
  Column<width> scale_{};
  Column<width> inverse_p_{};
  Column<width> sine_{};
  Column<width> versine_{};
  Column<width> lag_{};
  Column<width> bend_{};
  Column<width> pull_{};
  Column<width> fall_{};
  Column<width> least_v_{};
  Column<width> reach_{};
  Column<width> drag_{};
  Column<width> twice_zeta_{};
  Column<width> swell_{};
  Column<width> lift_{};
  Column<width> felt_{};
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
