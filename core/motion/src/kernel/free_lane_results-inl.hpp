// SPDX-License-Identifier: MIT

// The results of the half-cycle map in lanes: what the last half-cycle of an entry gives. Symbols
// as in free_lanes.cpp, formulas of docs/theory.md as in ending.hpp and phase_clock.hpp.

// Read once for each instruction set, as Highway requires.
#if defined(STILLPOINT_FREE_LANE_RESULTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STILLPOINT_FREE_LANE_RESULTS_INL
#undef STILLPOINT_FREE_LANE_RESULTS_INL
#else
#define STILLPOINT_FREE_LANE_RESULTS_INL
#endif

#include "batch_entries.hpp"

#include <stillpoint/core/elementary.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "kernel/lane_rotor-inl.hpp"
#include "kernel/lane_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

inline constexpr double no_entry = -1;  ///< the index of an idle lane

/// The numbers of an entry that waits, runs or has ended.
enum class RunValue : std::size_t {
  index,
  phi,
  notch,
  energy,    ///< of the last departure, (8)
  radius,    ///< that it gives, (2)
  passages,  ///< the first that is the same for all that wait
  cosine,    ///< of the deficit, as are the next two; only with times
  sine,
  quarters,
  count
};

/// Those of an idle lane, and from `passages` on of each entry that waits.
inline constexpr std::array<double, static_cast<std::size_t>(RunValue::count)> idle{
    no_entry, 1, 1, 0, 1, 0, 1, 0, 0};

template <Index count>
struct Runs {
  HWY_INLINE Column<count>& operator[](RunValue value) {
    return columns[static_cast<std::size_t>(value)];
  }

  std::array<Column<count>, idle.size()> columns{};
};

/// v / p; if p = 1 for all entries, without a division.
class OverP {
 public:
  explicit OverP(const EntryValues& p) : unit_(p.stride == 0 && *p.data == 1) {}
  HWY_INLINE V operator()(V v, V p) const { return unit_ ? v : hn::Div(v, p); }

 private:
  bool unit_;
};

/// The entries that have ended. When there is a vector of them, their results are computed and
/// stored in their places.
template <bool times>
class RetiredRuns {
 public:
  RetiredRuns(const BatchEntries& entries, const FreeLanesOutput& output)
      : entries_(entries), output_(output), over_(entries.p) {}

  Runs<2 * width> runs{};

  [[nodiscard]] HWY_INLINE Index count() const { return count_; }

  /// So many have been put behind the others.
  HWY_INLINE void added(Index more) {
    count_ += more;
    if (count_ >= width) {
      count_ -= width;
      finish(count_);
    }
  }

  HWY_INLINE void finish_rest() {
    for (Index i = count_; i < width; ++i) {
      runs[Of::index][i] = no_entry;
    }
    finish(0);
  }

 private:
  using Of = RunValue;

  struct Results {
    Column<width> half_cycles;
    Column<width, std::int64_t> outcome;
    Column<width> stop_position;
    Column<width> stop_time;
  };

  /// From i on, as the next two.
  HWY_INLINE void finish(Index i) {
    work_out(i);
    for (Index lane = 0; lane < width; ++lane) {
      const auto entry = static_cast<Index>(runs[Of::index][i + lane]);
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

  HWY_INLINE V values_of_retired(const EntryValues& entries, Index i) {
    if (entries.stride == 0) {
      return all(*entries.data);
    }
    Column<width> found;
    for (Index lane = 0; lane < width; ++lane) {
      const auto entry = static_cast<Index>(runs[Of::index][i + lane]);
      found[lane] = entry < 0 ? 1 : entries.data[entry];
    }
    return at(found, 0);
  }

  HWY_INLINE void work_out(Index i) {
    const V v0 = values_of_retired(entries_.v0, i);
    const V p = values_of_retired(entries_.p, i);
    const V speed = hn::Abs(v0);
    const V phi = at(runs[Of::phi], i);
    const V energy = at(runs[Of::energy], i);
    const V passages = at(runs[Of::passages], i);
    const V radius = at(runs[Of::radius], i);
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
    put(over_(hn::IfThenZeroElse(at_zero, signed_rest), p), results_.stop_position, 0);
    put(hn::Add(passages, all(1)), results_.half_cycles, 0);
    const Whole whole;
    const auto dead_zone = hn::Set(whole, static_cast<std::int64_t>(Outcome::stopped_in_dead_zone));
    const auto zero = hn::Set(whole, static_cast<std::int64_t>(Outcome::stopped_at_zero));
    hn::StoreU(hn::IfThenElse(hn::RebindMask(whole, at_zero), zero, dead_zone), whole,
               results_.outcome.numbers.data());
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

    const VectorRotor deficit{at(runs[Of::cosine], i), at(runs[Of::sine], i),
                              at(runs[Of::quarters], i)};
    const VectorDirection direction = between(outer, deficit);
    const V quarters = hn::Sub(outer.quarters, deficit.quarters);
    Column<width> abscissa;
    Column<width> ordinate;
    Column<width> angle;
    put(direction.x, abscissa, 0);
    put(direction.y, ordinate, 0);
    for (Index lane = 0; lane < width; ++lane) {
      angle[lane] = elementary::atan2(ordinate[lane], abscissa[lane]);
    }
    const V phase = hn::Add(hn::Mul(all(std::numbers::pi), half_turns),
                            hn::Add(hn::Mul(all(std::numbers::pi / 2), quarters), at(angle, 0)));
    put(over_(phase, p), results_.stop_time, 0);
  }

  const BatchEntries& entries_;
  const FreeLanesOutput& output_;
  OverP over_;
  Index count_{0};
  Results results_{};
};

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
