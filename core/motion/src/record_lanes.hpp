// SPDX-License-Identifier: MIT
#pragma once

// The vector kernel of the record batch, record_lanes.cpp, as the rest of core sees it. Plain
// arrays only, as in batch_entries.hpp.

#include "interface.hpp"

#include <array>
#include <cstddef>

namespace stillpoint {

/// This many motions share one pass over the record. More would not fit into the first-level cache
/// with all their metrics; fewer would leave more lanes idle once some have ended.
inline constexpr std::size_t record_lanes = 128;

/// What the vectors know of each motion, in the units of forced_run.hpp; not mirrored: u = p x.
enum class RecordValue : std::size_t {
  u,
  v,
  a,
  look,       ///< on a slide, the y from which it is examined: x = 0, the edge or never
  crest,      ///< at rest: no smaller |w + u| matters to the margin
  slack,      ///< of the margin, TippingMargin; infinite where nothing was decided
  scale,      ///< the last that changes from sample to sample
  sign,       ///< of v on a slide; 0 at rest
  phi,        ///< friction, on a slide with that sign
  edge,       ///< on a slide, the y where friction changes or a notch is; or never
  certain,    ///< at rest: up to this, |w + u| is certainly held
  felt,       ///< with damping: the most that the structure has felt while the mass slid, over p
  inverse_p,  ///< the first that never changes; then (F16) over an interval, IntervalTerms
  sine,
  versine,
  lag,
  bend,
  pull,
  fall,
  least_v,
  reach,  ///< with damping, as the rest
  drag,
  twice_zeta,
  swell,
  lift,
  count
};

struct RecordColumns {
  using Column = std::array<double, record_lanes>;

  [[nodiscard]] Column& operator[](RecordValue value) {
    return numbers[static_cast<std::size_t>(value)];
  }

  bool damped{false};  ///< all of them are, or none
  std::array<Column, static_cast<std::size_t>(RecordValue::count)> numbers{};
};

/// A sliding motion at a sample.
struct LanePoint {
  double u;
  double v;
  double a;
};

/// Handles what the vectors do not decide for a motion.
class LaneEvents : public Interface {
 public:
  /// x = 0 is passed in an interval, without a notch there, and nothing else happens: whether the
  /// motion goes on.
  virtual bool passes() = 0;

  /// With damping, from sample i to the next: the structure may feel more than before.
  virtual void feels(std::size_t i, const LanePoint& from, const LanePoint& to) = 0;

  /// Takes it from sample i to the next, with all rules, and its columns as well.
  virtual void through_interval(std::size_t i) = 0;
};

/// Takes the `count` lanes listed from sample `begin` to sample `end` of the record; `events` is
/// indexed by lane.
void run_record_lanes(const double* record, std::size_t begin, std::size_t end,
                      const std::size_t* lanes, std::size_t count, RecordColumns& columns,
                      LaneEvents* const* events);

}  // namespace stillpoint
