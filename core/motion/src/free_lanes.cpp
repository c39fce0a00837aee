// SPDX-License-Identifier: MIT

// The half-cycle map in lanes, docs/batch.md: each lane runs one entry of a batch with the
// operations of half_cycle_map.hpp, ending.hpp and phase_clock.hpp in their order, so that its
// results are those of free_response to the last bit.
//
// | here      | meaning                                                                        |
// |-----------|--------------------------------------------------------------------------------|
// | lane      | one double of a vector                                                         |
// | waiting   | entries prepared for a lane                                                    |
// | retired   | entries that have ended and whose results are not computed yet                |
// | ordinary  | an entry for the lanes; all others are run alone, by the scalar kernel         |
// | idle      | a dummy entry, in the lanes when no other is left                              |
//
// Highway compiles this file once for each instruction set and picks one at run time.

#include "free_lanes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "free_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "kernel/free_lane_results-inl.hpp"
#include "kernel/lane_rotor-inl.hpp"
#include "kernel/lane_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

namespace {

/// This many vectors hide the latency of a square root, and more where a lane does not stay in
/// registers: measured, docs/batch.md.
constexpr Index vectors = width >= 8 ? 8 : 12;
constexpr Index lanes = vectors * width;
constexpr int steps_between_refills = 4;  // a lane that has ended waits for half of them
constexpr std::uint64_t rounds_between_looks = 1U << 16U;  // some milliseconds

/// Beyond these powers of two the scalar kernel runs an entry: within them no step underflows
/// or overflows, scaled or not.
constexpr double least_speed = 0x1p-64;
constexpr double most_speed = 0x1p64;

constexpr std::size_t waiting_values = static_cast<std::size_t>(RunValue::passages);

template <bool times>
class FreeLanes {
 public:
  FreeLanes(const BatchEntries& entries, double half_cycle_limit, const FreeLanesOutput& output,
            FreeLanesSource& source)
      : entries_(entries),
        half_cycle_limit_(half_cycle_limit),
        output_(output),
        source_(source),
        over_(entries.p),
        retired_(entries, output) {}

  HWY_INLINE void run() {
    for (Index i = 0; i < lanes; i += width) {
      leave_idle(i);
    }
    do {
      for (Index i = 0; i < lanes; i += width) {
        going_on_[i / width] = hn::CountTrue(D(), half_cycle(i));
      }
      for (int step = 2; step < steps_between_refills; ++step) {
        for (Index i = 0; i < lanes; i += width) {
          half_cycle(i);
        }
      }
      for (Index i = 0; i < lanes; i += width) {
        const M goes_on = half_cycle(i);
        if (going_on_[i / width] <= most_going_on_) {
          refill(i, hn::Not(goes_on));
        }
      }
      if (++rounds_ % rounds_between_looks == 0 && !source_.goes_on()) {
        return;
      }
    } while (!drained_ || busy());
    retired_.finish_rest();
  }

 private:
  using Of = RunValue;

  // --- waiting entries ----------------------------------------------------------------------

  /// Makes a whole vector wait, with idle entries if no others are left.
  HWY_INLINE void supply() {
    while (waiting_count_ < width) {
      if (range_.end - range_.begin >= width) {
        prepare(range_.begin);
        range_.begin += width;
      } else if (range_.begin < range_.end) {
        source_.run_alone(range_.begin++);
      } else if (range_ = source_.next(); range_.begin == range_.end) {
        drained_ = true;
        most_going_on_ = width - 1;
        put_idle_below();
      }
    }
  }

  HWY_INLINE void put_idle_below() {
    for (std::size_t k = 0; k < waiting_values; ++k) {
      auto& column = waiting_.columns[k];
      put(at(column, 0), column, width);
      put(all(idle[k]), column, 0);
    }
    waiting_count_ += width;
  }

  /// The first leg from x = 0, (10) and (11).
  HWY_INLINE void prepare(Index begin) {
    const V speed = hn::Abs(values(entries_.v0, begin));
    const V p = values(entries_.p, begin);
    const V delta = values(entries_.delta, begin);
    const V phi = over_(values(entries_.f, begin), p);
    const V notch = hn::Add(delta, delta);
    const V energy = hn::Mul(speed, speed);
    const V radius = hn::Sqrt(hn::Add(energy, hn::Mul(phi, phi)));
    const M ordinary = hn::And(
        hn::And(
            hn::And(within(speed, least_speed, most_speed), within(phi, least_speed, most_speed)),
            hn::And(within(p, least_speed, most_speed),
                    within(notch, least_speed * least_speed, most_speed * most_speed))),
        hn::And(hn::Gt(energy, notch), surely_ends(energy, notch, radius, phi)));
    put(over_(peak(speed, radius, phi), p), output_.peak_amplitude + begin);

    const V index = hn::Add(hn::Iota(D(), 0), all(static_cast<double>(begin)));
    const bool all_ordinary = hn::AllTrue(D(), ordinary);
    const Order order = to_front(ordinary);
    const std::array<V, waiting_values> entry{index, phi, notch, energy, radius};
    for (std::size_t k = 0; k < waiting_values; ++k) {
      put(all_ordinary ? entry[k] : reordered(entry[k], order), waiting_.columns[k],
          waiting_count_);
    }
    waiting_count_ += static_cast<Index>(hn::CountTrue(D(), ordinary));
    if (!all_ordinary) {
      run_alone(begin, ordinary);
    }
  }

  HWY_INLINE void run_alone(Index begin, M ordinary) {
    Column<width> is_ordinary;
    put(hn::IfThenElseZero(ordinary, all(1)), is_ordinary, 0);
    for (Index lane = 0; lane < width; ++lane) {
      if (is_ordinary[lane] == 0) {
        source_.run_alone(begin + lane);
      }
    }
  }

  static HWY_INLINE V peak(V speed, V radius, V phi) {
    return hn::Mul(speed, hn::Div(speed, hn::Add(radius, phi)));
  }

  /// (16) is below the limit, with room for the rounding of this test.
  HWY_INLINE M surely_ends(V energy, V notch, V radius, V phi) const {
    const V limit = all(half_cycle_limit_ * (1 - 0x1p-40));
    return hn::Or(hn::Le(energy, hn::Mul(notch, limit)),
                  hn::Le(radius, hn::Mul(hn::Add(phi, phi), limit)));
  }

  // --- lanes --------------------------------------------------------------------------------

  HWY_INLINE void leave_idle(Index i) {
    for (std::size_t k = 0; k < idle.size(); ++k) {
      put(all(idle[k]), runs_.columns[k], i);
    }
    put(all(3), three_phi_, i);
    put(all(1), phi_square_, i);
  }

  HWY_INLINE bool busy() {
    M any = hn::Ge(at(runs_[Of::index], 0), hn::Zero(D()));
    for (Index i = width; i < lanes; i += width) {
      any = hn::Or(any, hn::Ge(at(runs_[Of::index], i), hn::Zero(D())));
    }
    return !hn::AllFalse(D(), any);
  }

  /// (4) to (8) for the vector from lane i on; true where the motion continues. Since r >= phi,
  /// even when rounded, a departure > 0 implies that the motion returns. A lane that has ended
  /// keeps its energy and so finds the same radius again.
  HWY_INLINE M half_cycle(Index i) {
    const V radius = at(runs_[Of::radius], i);
    const V arrival =
        hn::Mul(hn::Sub(radius, at(three_phi_, i)), hn::Sub(radius, at(runs_[Of::phi], i)));
    const V departure = hn::Sub(arrival, at(runs_[Of::notch], i));
    const M goes_on = hn::Gt(departure, hn::Zero(D()));
    const V energy = hn::IfThenElse(goes_on, departure, at(runs_[Of::energy], i));
    const V passages = at(runs_[Of::passages], i);
    put(energy, runs_[Of::energy], i);
    put(hn::Sqrt(hn::Add(energy, at(phi_square_, i))), runs_[Of::radius], i);
    put(hn::IfThenElse(goes_on, hn::Add(passages, all(1)), passages), runs_[Of::passages], i);
    if constexpr (times) {
      add_deficit(i, arrival, departure, goes_on);
    }
    return goes_on;
  }

  /// (15).
  HWY_INLINE void add_deficit(Index i, V arrival, V departure, M goes_on) {
    const V w = hn::Sqrt(arrival);
    const V v = hn::Sqrt(departure);
    const V c = hn::Mul(hn::Add(hn::Mul(w, v), at(phi_square_, i)), hn::Add(w, v));
    const V s = hn::Mul(at(runs_[Of::phi], i), at(runs_[Of::notch], i));
    VectorRotor deficit{at(runs_[Of::cosine], i), at(runs_[Of::sine], i),
                        at(runs_[Of::quarters], i)};
    turn(deficit, hn::IfThenElse(goes_on, c, all(1)), hn::IfThenElseZero(goes_on, s));
    put(deficit.cosine, runs_[Of::cosine], i);
    put(deficit.sine, runs_[Of::sine], i);
    put(deficit.quarters, runs_[Of::quarters], i);
  }

  /// Retires the lanes that have ended and gives them waiting entries: the ended lanes move to the
  /// front of the vector, and out from there.
  HWY_INLINE void refill(Index i, M ended) {
    supply();
    const auto count = hn::CountTrue(D(), ended);
    waiting_count_ -= static_cast<Index>(count);
    const M fresh = hn::FirstN(D(), count);
    const Order order = to_front(ended);

    for (std::size_t k = 0; k < (times ? idle.size() : waiting_values + 1); ++k) {
      const V ended_first = reordered(at(runs_.columns[k], i), order);
      const V waiting = k < waiting_values ? at(waiting_.columns[k], waiting_count_) : all(idle[k]);
      put(ended_first, retired_.runs.columns[k], retired_.count());
      put(hn::IfThenElse(fresh, waiting, ended_first), runs_.columns[k], i);
    }
    const V phi = at(runs_[Of::phi], i);
    put(hn::Mul(all(3), phi), three_phi_, i);
    put(hn::Mul(phi, phi), phi_square_, i);
    retired_.added(static_cast<Index>(count));
  }

  const BatchEntries& entries_;
  double half_cycle_limit_;
  const FreeLanesOutput& output_;
  FreeLanesSource& source_;
  OverP over_;
  EntryRange range_{0, 0};

  Runs<2 * width> waiting_{};  // last in, first out
  Index waiting_count_{0};
  bool drained_{false};  // no entries are left but those that wait here
  std::uint64_t rounds_{0};

  Runs<lanes> runs_{};
  Column<lanes> three_phi_{};
  Column<lanes> phi_square_{};

  /// A vector is refilled when this few of its lanes go on: a few idle steps cost less than a
  /// refill for each lane, and with times a step costs more.
  std::size_t most_going_on_{times ? width * 3 / 4 : width * 5 / 8};
  Column<vectors, std::size_t> going_on_;  // in each vector, some steps ago

  RetiredRuns<times> retired_;
};

void run_lanes(const BatchEntries& entries, double half_cycle_limit, const FreeLanesOutput& output,
               FreeLanesSource& source) {
  if (output.stop_time != nullptr) {
    FreeLanes<true>(entries, half_cycle_limit, output, source).run();
  } else {
    FreeLanes<false>(entries, half_cycle_limit, output, source).run();
  }
}

}  // namespace

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stillpoint {

namespace {
HWY_EXPORT(run_lanes);
}  // namespace

void run_free_lanes(const BatchEntries& entries, double half_cycle_limit,
                    const FreeLanesOutput& output, FreeLanesSource& source) {
  HWY_DYNAMIC_DISPATCH(run_lanes)(entries, half_cycle_limit, output, source);
}

}  // namespace stillpoint
#endif
