// SPDX-License-Identifier: MIT

// The half-cycle map with damping in lanes: each runs one entry of a batch by damped_swing-inl.hpp,
// as damped_free.cpp does. Highway compiles this file once for each instruction set and picks one
// at run time.

#include "damped_lanes.hpp"

#include <array>
#include <bit>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "damped_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "kernel/damped_swing-inl.hpp"
#include "kernel/lane_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

namespace {

/// A number of each lane of two vectors: one alone would wait for its own steps.
struct Wide {
  V a;
  V b;

  HWY_INLINE Wide(V of_a, V of_b) : a(of_a), b(of_b) {}
  HWY_INLINE Wide(double of) : Wide(all(of), all(of)) {}  // NOLINT(google-explicit-constructor)

  friend HWY_INLINE Wide operator+(Wide x, Wide y) {
    return {hn::Add(x.a, y.a), hn::Add(x.b, y.b)};
  }
  friend HWY_INLINE Wide operator-(Wide x, Wide y) {
    return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)};
  }
  friend HWY_INLINE Wide operator*(Wide x, Wide y) {
    return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)};
  }
  friend HWY_INLINE Wide operator/(Wide x, Wide y) {
    return {hn::Div(x.a, y.a), hn::Div(x.b, y.b)};
  }
};

HWY_INLINE Wide root(Wide x) {
  return {hn::Sqrt(x.a), hn::Sqrt(x.b)};
}

HWY_INLINE Wide where_more(Wide left, Wide right, Wide x, Wide y) {
  return {hn::IfThenElse(hn::Gt(left.a, right.a), x.a, y.a),
          hn::IfThenElse(hn::Gt(left.b, right.b), x.b, y.b)};
}

/// Where x > 0, one bit for each lane.
HWY_INLINE std::uint64_t positive(Wide x) {
  return bits(hn::Gt(x.a, hn::Zero(D()))) | std::uint64_t{bits(hn::Gt(x.b, hn::Zero(D())))}
                                                << static_cast<unsigned>(width);
}

constexpr Index step = 2 * width;
constexpr Index lanes = 4 * step;
static_assert(lanes <= 64);                                // one bit each
constexpr std::uint64_t rounds_between_looks = 1U << 12U;  // some milliseconds

class DampedLanes {
 public:
  explicit DampedLanes(DampedLanesSource& source) : source_(source) {}

  HWY_INLINE void run() {
    for (Index lane = 0; lane < lanes; ++lane) {
      refill(lane);
    }
    while (running_ != 0) {
      std::uint64_t ended = 0;  // looked at only after all vectors: a wrong guess makes all wait
      for (Index i = 0; i < lanes; i += step) {
        ended |= half_cycle(i) << static_cast<unsigned>(i);
      }
      for (ended &= running_; ended != 0; ended &= ended - 1) {
        const int lane = std::countr_zero(ended);
        source_.end(static_cast<std::size_t>(lane), values_of(lane));
        refill(lane);
      }
      if (++rounds_ % rounds_between_looks == 0 && !source_.goes_on()) {
        return;
      }
    }
  }

 private:
  HWY_INLINE Column<lanes>& column(LaneValue value) {
    return columns_[static_cast<std::size_t>(value)];
  }
  HWY_INLINE Wide get(LaneValue value, Index i) {
    return {at(column(value), i), at(column(value), i + width)};
  }
  HWY_INLINE void keep(Wide x, LaneValue value, Index i) {
    put(x.a, column(value), i);
    put(x.b, column(value), i + width);
  }

  HWY_INLINE LaneValues values_of(Index lane) const {
    LaneValues values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = columns_[i][lane];
    }
    return values;
  }

  /// A lane without an entry stays at rest.
  HWY_INLINE void refill(Index lane) {
    LaneValues values{};
    const std::uint64_t one = std::uint64_t{1} << static_cast<unsigned>(lane);
    const bool runs = source_.begin(static_cast<std::size_t>(lane), values);
    running_ = runs ? running_ | one : running_ & ~one;
    for (std::size_t i = 0; i < values.size(); ++i) {
      columns_[i][lane] = values[i];
    }
  }

  /// As DampedRun::half_cycle, from lane i on; a bit for each lane whose motion has ended.
  HWY_INLINE std::uint64_t half_cycle(Index i) {
    const DampedSwing<Wide> swing{get(LaneValue::phi, i), get(LaneValue::zeta, i),
                                  get(LaneValue::decay, i)};
    const Wide none(0);
    const Wide speed = get(LaneValue::speed, i);
    const Wide passages = get(LaneValue::passages, i);
    const DampedReach<Wide> up = swing.reach(speed);
    const Wide peak = swing.peak(up);
    const Wide excursion = swing.next(peak);
    const DampedArrival<Wide> back = swing.arrival(excursion);
    // What the arrival leaves, of those who arrive; that is never 0.
    const Wide left =
        where_more(peak, get(LaneValue::held, i), back.energy - get(LaneValue::notch, i), none);
    const Wide at_peak = get(LaneValue::phase, i) + up.time;
    keep(where_more(left, none, root(left), speed), LaneValue::speed, i);
    keep(where_more(left, none, at_peak - back.time, at_peak), LaneValue::phase, i);
    keep(where_more(left, none, passages + 1, passages), LaneValue::passages, i);
    keep(where_more(passages, none, get(LaneValue::farthest, i), peak), LaneValue::farthest, i);
    keep(peak, LaneValue::peak, i);
    keep(excursion, LaneValue::excursion, i);
    keep(back.time, LaneValue::late, i);
    return ~positive(left) & ((std::uint64_t{1} << static_cast<unsigned>(step)) - 1);
  }

  DampedLanesSource& source_;
  std::array<Column<lanes>, static_cast<std::size_t>(LaneValue::count)> columns_{};
  std::uint64_t running_{0};  ///< the lanes with an entry, one bit each
  std::uint64_t rounds_{0};
};

void run_lanes(DampedLanesSource& source) {
  DampedLanes(source).run();
}

}  // namespace

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stillpoint {

namespace {
HWY_EXPORT(run_lanes);
}  // namespace

void run_damped_lanes(DampedLanesSource& source) {
  HWY_DYNAMIC_DISPATCH(run_lanes)(source);
}

}  // namespace stillpoint
#endif
