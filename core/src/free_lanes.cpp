// SPDX-License-Identifier: MIT

// The half-cycle map in lanes, docs/batch.md: each lane runs one entry of a batch with the
// operations of half_cycle_map.hpp, ending.hpp and phase_clock.hpp in their order, so that its
// results are those of free_response to the last bit.
//
// | here      | meaning                                                                        |
// |-----------|--------------------------------------------------------------------------------|
// | lane      | one double of a vector                                                         |
// | waiting   | entries prepared for a lane                                                    |
// | retired   | entries that have ended and whose results are still to be worked out           |
// | ordinary  | an entry for the lanes; all others are run alone, by the scalar kernel         |
// | idle      | an entry that is none, in the lanes when no other is left                      |
//
// Highway compiles this file once for each instruction set and picks one at run time.

#include "free_lanes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "free_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Index = std::ptrdiff_t;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using Bits = hn::RebindToUnsigned<D>;
using Whole = hn::RebindToSigned<D>;

constexpr Index width = static_cast<Index>(hn::MaxLanes(D()));
constexpr Index lanes = 8 * width;        // so many vectors hide the latency of a square root
constexpr int steps_between_refills = 4;  // a lane that has ended waits for half of them
constexpr double no_entry = -1;

/// Beyond these powers of two an entry is left to the scalar kernel: within them no step underflows
/// or overflows, scaled or not.
constexpr double least_speed = 0x1p-64;
constexpr double most_speed = 0x1p64;

HWY_INLINE V all(double value) {
  return hn::Set(D(), value);
}

HWY_INLINE V at(const double* data) {
  return hn::LoadU(D(), data);
}

HWY_INLINE V values(const EntryValues& entries, Index begin) {
  return entries.stride == 0 ? all(*entries.data) : at(entries.data + begin);
}

HWY_INLINE void put(V v, double* data) {
  hn::StoreU(v, D(), data);
}

HWY_INLINE M within(V v, double low, double high) {
  return hn::And(hn::Ge(v, all(low)), hn::Le(v, all(high)));
}

/// A permutation of a vector.
using Order = decltype(hn::IndicesFromVec(D(), hn::Zero(Bits())));

/// For each mask, the numbers of the lanes in it, then of the others: four bits each.
constexpr auto chosen_first = [] {
  std::array<std::uint64_t, 1U << width> table{};
  for (std::size_t mask = 0; mask < table.size(); ++mask) {
    unsigned place = 0;
    for (const std::size_t chosen : {1U, 0U}) {
      for (unsigned lane = 0; lane < width; ++lane) {
        if ((mask >> lane & 1U) == chosen) {
          table[mask] |= std::uint64_t{lane} << (4 * place++);
        }
      }
    }
  }
  return table;
}();

/// Brings the lanes of the mask to the front. Highway's Compress does the same, but copies its
/// table at each call where GCC 12 compiles it.
HWY_INLINE Order to_front(M mask) {
  const Bits bits;
  std::uint8_t number[8];
  hn::StoreMaskBits(D(), mask, number);
  const auto packed = hn::Set(bits, chosen_first[number[0]]);
  const auto shift = hn::ShiftLeft<2>(hn::Iota(bits, 0));
  return hn::IndicesFromVec(D(), hn::And(hn::Shr(packed, shift), hn::Set(bits, 15)));
}

HWY_INLINE V reordered(V v, Order order) {
  return hn::TableLookupLanes(v, order);
}

/// Rotor of rotor.hpp.
struct VectorRotor {
  V cosine;
  V sine;
  V quarters;
};

HWY_INLINE V unit_scale(V size) {
  const Bits bits;
  const auto exponent = hn::And(hn::BitCast(bits, size), hn::Set(bits, 0x7ff0000000000000));
  return hn::BitCast(D(), hn::Sub(hn::Set(bits, 0x7fe0000000000000), exponent));
}

HWY_INLINE void turn(VectorRotor& rotor, V c, V s) {
  const V x = hn::Sub(hn::Mul(rotor.cosine, c), hn::Mul(rotor.sine, s));
  const V y = hn::Add(hn::Mul(rotor.sine, c), hn::Mul(rotor.cosine, s));
  const M beyond = hn::Lt(x, hn::Zero(D()));
  const V cosine = hn::IfThenElse(beyond, y, x);
  const V sine = hn::IfThenElse(beyond, hn::Neg(x), y);
  rotor.quarters = hn::Add(rotor.quarters, hn::IfThenElseZero(beyond, all(1)));
  const V scale = unit_scale(hn::Add(cosine, sine));
  rotor.cosine = hn::Mul(cosine, scale);
  rotor.sine = hn::Mul(sine, scale);
}

/// Of an entry that waits, runs or has ended.
template <std::size_t count>
struct Entries {
  HWY_ALIGN double index[count];
  HWY_ALIGN double phi[count];
  HWY_ALIGN double energy[count];  // of the last departure, (8)
  HWY_ALIGN double radius[count];  // that it gives, (2)
};

template <std::size_t count>
struct Waiting : Entries<count> {
  HWY_ALIGN double notch[count];
};

template <std::size_t count>
struct Runs : Entries<count> {
  HWY_ALIGN double passages[count];
  HWY_ALIGN double cosine[count];  // of the deficit, as are the next two
  HWY_ALIGN double sine[count];
  HWY_ALIGN double quarters[count];
};

struct Results {
  HWY_ALIGN double half_cycles[width];
  HWY_ALIGN std::int64_t outcome[width];
  HWY_ALIGN double stop_position[width];
  HWY_ALIGN double stop_time[width];
};

template <bool times>
class FreeLanes {
 public:
  FreeLanes(const BatchEntries& entries, double half_cycle_limit, const FreeLanesOutput& output,
            FreeLanesSource& source)
      : entries_(entries),
        half_cycle_limit_(half_cycle_limit),
        output_(output),
        source_(source),
        unit_p_(entries.p.stride == 0 && *entries.p.data == 1) {}

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
    } while (!drained_ || busy());
    finish_rest();
  }

 private:
  // --- waiting entries ----------------------------------------------------------------------

  /// Sees to it that a whole vector waits: of idle entries where no others are left.
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
    for (double* column :
         {waiting_.index, waiting_.phi, waiting_.energy, waiting_.radius, waiting_.notch}) {
      put(at(column), column + width);
    }
    put(all(no_entry), waiting_.index);
    put(all(1), waiting_.phi);
    put(all(0), waiting_.energy);
    put(all(1), waiting_.radius);
    put(all(1), waiting_.notch);
    waiting_count_ += width;
  }

  /// The first leg from x = 0, (10) and (11).
  HWY_INLINE void prepare(Index begin) {
    const V speed = hn::Abs(values(entries_.v0, begin));
    const V p = values(entries_.p, begin);
    const V delta = values(entries_.delta, begin);
    const V phi = over(values(entries_.f, begin), p);
    const V notch = hn::Add(delta, delta);
    const V energy = hn::Mul(speed, speed);
    const V radius = hn::Sqrt(hn::Add(energy, hn::Mul(phi, phi)));
    const M ordinary = hn::And(
        hn::And(
            hn::And(within(speed, least_speed, most_speed), within(phi, least_speed, most_speed)),
            hn::And(within(p, least_speed, most_speed),
                    within(notch, least_speed * least_speed, most_speed * most_speed))),
        hn::And(hn::Ge(energy, notch), surely_ends(energy, notch, radius, phi)));
    put(over(peak(speed, radius, phi), p), output_.peak_amplitude + begin);

    const V index = hn::Add(hn::Iota(D(), 0), all(static_cast<double>(begin)));
    if (hn::AllTrue(D(), ordinary)) {
      put(index, waiting_.index + waiting_count_);
      put(phi, waiting_.phi + waiting_count_);
      put(energy, waiting_.energy + waiting_count_);
      put(radius, waiting_.radius + waiting_count_);
      put(notch, waiting_.notch + waiting_count_);
      waiting_count_ += width;
      return;
    }
    const Order order = to_front(ordinary);
    put(reordered(index, order), waiting_.index + waiting_count_);
    put(reordered(phi, order), waiting_.phi + waiting_count_);
    put(reordered(energy, order), waiting_.energy + waiting_count_);
    put(reordered(radius, order), waiting_.radius + waiting_count_);
    put(reordered(notch, order), waiting_.notch + waiting_count_);
    waiting_count_ += static_cast<Index>(hn::CountTrue(D(), ordinary));
    run_alone(begin, ordinary);
  }

  HWY_INLINE void run_alone(Index begin, M ordinary) {
    HWY_ALIGN double is_ordinary[width];
    put(hn::IfThenElseZero(ordinary, all(1)), is_ordinary);
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
    put(all(no_entry), runs_.index + i);
    put(all(1), runs_.phi + i);
    put(all(1), notch_ + i);
    put(all(3), three_phi_ + i);
    put(all(1), phi_square_ + i);
    put(all(0), runs_.energy + i);
    put(all(1), runs_.radius + i);
    put(all(0), runs_.passages + i);
    put(all(1), runs_.cosine + i);
    put(all(0), runs_.sine + i);
    put(all(0), runs_.quarters + i);
  }

  HWY_INLINE bool busy() const {
    M any = hn::Ge(at(runs_.index), hn::Zero(D()));
    for (Index i = width; i < lanes; i += width) {
      any = hn::Or(any, hn::Ge(at(runs_.index + i), hn::Zero(D())));
    }
    return !hn::AllFalse(D(), any);
  }

  /// (4) to (8) for the vector from lane i on; true where the motion goes on. Since r >= phi, also
  /// when rounded, a departure > 0 says that the motion returns. A lane that has ended keeps its
  /// energy and so finds the same radius again.
  HWY_INLINE M half_cycle(Index i) {
    const V radius = at(runs_.radius + i);
    const V arrival =
        hn::Mul(hn::Sub(radius, at(three_phi_ + i)), hn::Sub(radius, at(runs_.phi + i)));
    const V departure = hn::Sub(arrival, at(notch_ + i));
    const M goes_on = hn::Gt(departure, hn::Zero(D()));
    const V energy = hn::IfThenElse(goes_on, departure, at(runs_.energy + i));
    const V passages = at(runs_.passages + i);
    put(energy, runs_.energy + i);
    put(hn::Sqrt(hn::Add(energy, at(phi_square_ + i))), runs_.radius + i);
    put(hn::IfThenElse(goes_on, hn::Add(passages, all(1)), passages), runs_.passages + i);
    if constexpr (times) {
      add_deficit(i, arrival, departure, goes_on);
    }
    return goes_on;
  }

  /// (15).
  HWY_INLINE void add_deficit(Index i, V arrival, V departure, M goes_on) {
    const V w = hn::Sqrt(arrival);
    const V v = hn::Sqrt(departure);
    const V c = hn::Mul(hn::Add(hn::Mul(w, v), at(phi_square_ + i)), hn::Add(w, v));
    const V s = hn::Mul(at(runs_.phi + i), at(notch_ + i));
    VectorRotor deficit{at(runs_.cosine + i), at(runs_.sine + i), at(runs_.quarters + i)};
    turn(deficit, hn::IfThenElse(goes_on, c, all(1)), hn::IfThenElseZero(goes_on, s));
    put(deficit.cosine, runs_.cosine + i);
    put(deficit.sine, runs_.sine + i);
    put(deficit.quarters, runs_.quarters + i);
  }

  /// Retires the lanes that have ended and gives them waiting entries: they move to the front of
  /// the vector, and from there out.
  HWY_INLINE void refill(Index i, M ended) {
    supply();
    const auto count = hn::CountTrue(D(), ended);
    waiting_count_ -= static_cast<Index>(count);
    const M fresh = hn::FirstN(D(), count);
    const Order order = to_front(ended);

    exchange(runs_.index + i, order, fresh, retired_.index, at(waiting_.index + waiting_count_));
    const V phi =
        exchange(runs_.phi + i, order, fresh, retired_.phi, at(waiting_.phi + waiting_count_));
    exchange(runs_.energy + i, order, fresh, retired_.energy, at(waiting_.energy + waiting_count_));
    exchange(runs_.radius + i, order, fresh, retired_.radius, at(waiting_.radius + waiting_count_));
    exchange(runs_.passages + i, order, fresh, retired_.passages, all(0));
    if constexpr (times) {
      exchange(runs_.cosine + i, order, fresh, retired_.cosine, all(1));
      exchange(runs_.sine + i, order, fresh, retired_.sine, all(0));
      exchange(runs_.quarters + i, order, fresh, retired_.quarters, all(0));
    }
    put(hn::IfThenElse(fresh, at(waiting_.notch + waiting_count_),
                       reordered(at(notch_ + i), order)),
        notch_ + i);
    put(hn::Mul(all(3), phi), three_phi_ + i);
    put(hn::Mul(phi, phi), phi_square_ + i);
    retired_count_ += static_cast<Index>(count);
    if (retired_count_ >= width) {
      retired_count_ -= width;
      finish(retired_count_);
    }
  }

  HWY_INLINE V exchange(double* lane, Order order, M fresh, double* retired, V waiting) {
    const V ended_first = reordered(at(lane), order);
    const V now = hn::IfThenElse(fresh, waiting, ended_first);
    put(ended_first, retired + retired_count_);
    put(now, lane);
    return now;
  }

  // --- results ------------------------------------------------------------------------------

  HWY_INLINE void finish_rest() {
    for (Index i = retired_count_; i < width; ++i) {
      retired_.index[i] = no_entry;
    }
    finish(0);
  }

  /// Works out the results of the retired from i on, and takes them to their places.
  HWY_INLINE void finish(Index i) {
    work_out(i);
    for (Index lane = 0; lane < width; ++lane) {
      const auto entry = static_cast<Index>(retired_.index[i + lane]);
      if (entry >= 0) {
        output_.half_cycles[entry] = results_.half_cycles[lane];
        output_.outcome[entry] = static_cast<Outcome>(results_.outcome[lane]);
        output_.stop_position[entry] = results_.stop_position[lane];
        if constexpr (times) {
          output_.stop_time[entry] = results_.stop_time[lane];
        }
      }
    }
  }

  /// Of the retired from i on.
  HWY_INLINE V values_of_retired(const EntryValues& entries, Index i) {
    if (entries.stride == 0) {
      return all(*entries.data);
    }
    HWY_ALIGN double found[width];
    for (Index lane = 0; lane < width; ++lane) {
      const auto entry = static_cast<Index>(retired_.index[i + lane]);
      found[lane] = entry < 0 ? 1 : entries.data[entry];
    }
    return at(found);
  }

  HWY_INLINE void work_out(Index i) {
    const V v0 = values_of_retired(entries_.v0, i);
    const V p = values_of_retired(entries_.p, i);
    const V speed = hn::Abs(v0);
    const V phi = at(retired_.phi + i);
    const V energy = at(retired_.energy + i);
    const V passages = at(retired_.passages + i);
    const V radius = at(retired_.radius + i);
    const V three_phi = hn::Mul(all(3), phi);
    const M at_zero = hn::Ge(radius, three_phi);          // (4)
    const M at_peak = hn::Le(radius, hn::Add(phi, phi));  // (5)
    const M passed = hn::Gt(passages, hn::Zero(D()));
    const V quotient = hn::Div(hn::IfThenElse(passed, energy, speed), hn::Add(radius, phi));
    const V peak = hn::IfThenElse(passed, quotient, hn::Mul(speed, quotient));  // (3), (11)
    const V rest = hn::IfThenElse(at_peak, peak, hn::Sub(three_phi, radius));   // (6)
    const V half = hn::Mul(passages, all(0.5));
    const M odd = hn::Ne(hn::Floor(half), half);
    const V turned = hn::IfThenElse(odd, hn::Neg(rest), rest);
    const V signed_rest = hn::Xor(turned, hn::And(v0, hn::SignBit(D())));
    put(over(hn::IfThenZeroElse(at_zero, signed_rest), p), results_.stop_position);
    put(hn::Add(passages, all(1)), results_.half_cycles);
    const Whole whole;
    const auto dead_zone = hn::Set(whole, static_cast<std::int64_t>(Outcome::stopped_in_dead_zone));
    const auto zero = hn::Set(whole, static_cast<std::int64_t>(Outcome::stopped_at_zero));
    hn::StoreU(hn::IfThenElse(hn::RebindMask(whole, at_zero), zero, dead_zone), whole,
               results_.outcome);
    if constexpr (times) {
      const M swings_back = hn::Not(hn::Or(at_zero, at_peak));
      const V half_turns = hn::Add(passages, hn::IfThenElseZero(swings_back, all(1)));
      work_out_time(i, speed, phi, radius, at_zero, half_turns, p);
    }
  }

  /// PhaseClock of phase_clock.hpp.
  HWY_INLINE void work_out_time(Index i, V speed, V phi, V radius, M at_zero, V half_turns, V p) {
    VectorRotor outer{all(1), all(0), all(0)};
    turn(outer, phi, speed);
    const V three_phi = hn::Mul(all(3), phi);
    const V w = hn::Sqrt(hn::Mul(hn::Sub(radius, three_phi), hn::Sub(radius, phi)));
    VectorRotor down = outer;
    turn(down, w, phi);
    outer.cosine = hn::IfThenElse(at_zero, down.cosine, outer.cosine);
    outer.sine = hn::IfThenElse(at_zero, down.sine, outer.sine);
    outer.quarters = hn::IfThenElse(at_zero, hn::Add(down.quarters, all(1)), outer.quarters);

    const V cosine = at(retired_.cosine + i);
    const V sine = at(retired_.sine + i);
    const V x = hn::Add(hn::Mul(outer.cosine, cosine), hn::Mul(outer.sine, sine));
    const V y = hn::Sub(hn::Mul(outer.sine, cosine), hn::Mul(outer.cosine, sine));
    const V scale = unit_scale(hn::Add(x, hn::Abs(y)));
    const V quarters = hn::Sub(outer.quarters, at(retired_.quarters + i));
    HWY_ALIGN double abscissa[width];
    HWY_ALIGN double ordinate[width];
    HWY_ALIGN double angle[width];
    put(hn::Mul(x, scale), abscissa);
    put(hn::Mul(y, scale), ordinate);
    for (Index lane = 0; lane < width; ++lane) {
      angle[lane] = std::atan2(ordinate[lane], abscissa[lane]);
    }
    const V phase = hn::Add(hn::Mul(all(std::numbers::pi), half_turns),
                            hn::Add(hn::Mul(all(std::numbers::pi / 2), quarters), at(angle)));
    put(over(phase, p), results_.stop_time);
  }

  /// v / p.
  HWY_INLINE V over(V v, V p) const { return unit_p_ ? v : hn::Div(v, p); }

  const BatchEntries& entries_;
  double half_cycle_limit_;
  const FreeLanesOutput& output_;
  FreeLanesSource& source_;
  bool unit_p_;  // the same for all, and no division by it is needed
  EntryRange range_{0, 0};

  Waiting<2 * width> waiting_{};  // the last to come is the first to go
  Index waiting_count_{0};
  bool drained_{false};  // no entries are left but those that wait here

  Runs<lanes> runs_{};
  HWY_ALIGN double notch_[lanes]{};
  HWY_ALIGN double three_phi_[lanes]{};
  HWY_ALIGN double phi_square_[lanes]{};

  /// A vector is refilled when so few of its lanes go on: a few idle steps cost less than a refill
  /// for each lane, and with times a step costs more.
  std::size_t most_going_on_{times ? width * 3 / 4 : width * 5 / 8};
  std::size_t going_on_[lanes / width]{};  // in each vector, some steps ago

  Runs<2 * width> retired_{};
  Index retired_count_{0};
  Results results_{};
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
