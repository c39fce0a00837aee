// SPDX-License-Identifier: MIT
#pragma once

// The rules of the motion under an excitation, docs/forced.md section 1, written once for double
// and for a multiprecision scalar. In units where p = 1, as half_cycle_map.hpp:
//
// | here     | means                                                   |
// |----------|---------------------------------------------------------|
// | u        | p x                                                     |
// | v        | x'                                                      |
// | w        | W / p                                                   |
// | phi      | f / p                                                   |
// | notch    | 2 Delta                                                 |
// | h, now   | p tau, of a piece and of the run                        |
//
// A drive (drives.hpp) is a stretch of the excitation without a kink. `through` takes the motion
// through one; kinks are where the next begins. A watcher sees every event and every piece. A law
// (constant_friction.hpp, zoned_friction.hpp) gives the friction at a position.

#include "kernel/constant_friction.hpp"
#include "kernel/drives.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/forced_state.hpp"
#include "kernel/functions.hpp"
#include "kernel/half_cycle_map.hpp"
#include "kernel/piece_end.hpp"
#include "kernel/rest.hpp"
#include "kernel/run_margin.hpp"
#include "kernel/touch.hpp"
#include "kernel/transmitted.hpp"
#include "kernel/zone_slide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/state.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace stillpoint {

template <class Real, class Watcher = NoWatcher, class Law = ConstantFriction<Real>>
class ForcedRun {
 public:
  using AnyWatcher = Watcher;
  using AnyLaw = Law;

  /// The sliding piece that a drive makes of a state.
  template <class Drive>
  [[nodiscard]] auto piece(Drive& drive, const Sliding<Real>& from) const {
    return piece_under(law_, drive, from);
  }
  template <class Drive>
  using CrossingUnder = Crossing<decltype(piece_under(
      std::declval<const Law&>(), std::declval<Drive&>(), std::declval<const Sliding<Real>&>()))>;

  ForcedRun(const BasicOscillator<Real>& oscillator, const BasicStart<Real>& start,
            Watcher& watcher, Patience patience = {})
      : ForcedRun(oscillator, Law(oscillator), start, watcher, std::move(patience)) {}

  ForcedRun(const BasicOscillator<Real>& oscillator, Law law, const BasicStart<Real>& start,
            Watcher& watcher, Patience patience = {})
      : map_(oscillator), law_(std::move(law)), watcher_(watcher), patience_(std::move(patience)) {
    begin(start);
  }

  [[nodiscard]] const ForcedState<Real>& state() const { return s_; }
  [[nodiscard]] ForcedState<Real>& state() { return s_; }
  [[nodiscard]] const HalfCycleMap<Real>& map() const { return map_; }
  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] Law& law() { return law_; }
  [[nodiscard]] bool over() const { return s_.mode == ForcedMode::over; }
  [[nodiscard]] bool cancelled() const { return patience_.ended(); }

  /// More half-cycles throw TooManyHalfCycles.
  void allow_half_cycles(double most) { most_passages_ = static_cast<std::int64_t>(most) - 1; }

  /// Follows the motion for `length` under one drive; `for_ever`: no other drive follows.
  template <class Drive>
  void through(Drive& drive, const ExactSum<Real>& length, bool for_ever) {
    std::optional<CrossingUnder<Drive>> last;
    through(drive, length, for_ever, last);
    arrived(last);
  }

  /// The same, but the last crossing of x = 0 without a notch is left to the caller: a caller that
  /// goes through many drives needs the speed of the very last crossing only.
  template <class Drive>
  void through(Drive& drive, const ExactSum<Real>& length, bool for_ever,
               std::optional<CrossingUnder<Drive>>& last) {
    ExactSum<Real> left = length;
    // A released mass slides under the same drive: the wait was shorter than the rest of the drive.
    assert(s_.mode != ForcedMode::sliding || s_.v != 0);
    while (!over() && left.value() > 0 && tick()) {
      if (s_.mode == ForcedMode::resting) {
        rest(*this, drive, left, for_ever);
      } else {
        slide(drive, left, last);
      }
    }
  }

  /// The speed at the last crossing of x = 0, if there was any.
  template <class AnyCrossing>
  void arrived(const std::optional<AnyCrossing>& last) {
    if (last) {
      s_.arrival_speed = last->piece.arrival_before(last->end).at.v;
    }
  }

  /// Follows the motion under a drive that lasts until v = 0, and leaves the decision there open.
  template <class Drive>
  void slide_to_turn(Drive& drive) {
    while (s_.mode == ForcedMode::sliding && tick()) {
      std::optional<CrossingUnder<Drive>> last;
      ExactSum<Real> left(longer_than_a_piece());
      slide(drive, left, last);
      arrived(last);
    }
    if (!over()) {
      s_.mode = ForcedMode::resting;
    }
  }

  /// No excitation from here on: at rest inside the dead zone the mass stays for ever.
  void settle() {
    if (s_.mode == ForcedMode::resting) {
      decide_hold(*this, Load<Real>());
      if (magnitude(s_.u) <= law_.capacity(s_.u, s_.u > 0 ? 1 : -1)) {
        stop_where_it_rests();
      }
    }
  }

  /// Under a permanent load that does not hold the mass where it rests.
  template <class Drive>
  void set_off_under(Drive& drive) {
    ExactSum<Real> left(Real(1));
    rest(*this, drive, left, true);
  }

  /// Once per piece; false if the run should end.
  bool tick() {
    if (patience_.lasts([this] { return static_cast<double>(Real(s_.now.value() / map_.p)); })) {
      return true;
    }
    s_.mode = ForcedMode::over;
    return false;
  }

  /// At rest for ever, since rest_begin: that may be known only later, when the load is over.
  void stop(Outcome outcome) {
    s_.mode = ForcedMode::over;
    s_.outcome = outcome;
    event(EventKind::rest, s_.rest_begin);
  }

  void stop_where_it_rests() {
    stop(s_.caught && !s_.moved ? Outcome::caught_at_start : law_.rest_at(s_.u));
  }

  void event(EventKind kind) { event(kind, s_.now); }

  void event(EventKind kind, const ExactSum<Real>& when) {
    if constexpr (Watcher::watches) {
      watcher_.event(kind, when, s_.u, s_.v);
    }
  }

  Watcher& watcher() { return watcher_; }

  /// Rule 1, with a notch; the mass has come to x = 0 with s_.v.
  void arrive() {
    const Real energy = s_.v * s_.v;
    const Real left = map_.departure(energy);
    const Real speed = magnitude(s_.v);
    s_.u = Real(0);
    s_.arrival_speed = speed;
    event(EventKind::arrival);
    s_.margin.decide(magnitude(left), energy + map_.notch);
    s_.margin.decide(energy, energy + s_.farthest * s_.farthest);  // against a turn before x = 0
    if (!(left > 0)) {
      s_.jump = std::max(s_.jump, speed);
      come_to_rest();
      if (!law_.lets_go()) {
        stop(Outcome::stopped_at_zero);
      }
      return;
    }
    using std::sqrt;
    const Real departure = sqrt(left);
    s_.jump = std::max(s_.jump, Real(map_.notch / (speed + departure)));
    s_.v = Real(s_.direction) * departure;
    pass();
    event(EventKind::passage);
  }

  /// v = 0 has been reached; the load decides what follows, this one or the one after a kink.
  void turn() {
    come_to_rest();
    if (s_.u != 0) {
      ++s_.turning_points;
    }
    const Real distance = magnitude(s_.u);
    s_.farthest = std::max(s_.farthest, distance);
    // How far friction alone would have moved the mass: docs/forced.md section 7.
    const Real slid = std::min(Real(s_.now.value() - s_.slide_begin), Real(2));
    const Real pushed = law_.phi_ahead(Real(s_.direction) * s_.u) * slid * slid / 2;
    s_.margin.decide(law_.from_edge(distance), s_.farthest + pushed);
    event(EventKind::turn);
  }

  /// x = 0 has been passed.
  void pass() {
    if (++s_.passages > most_passages_) {
      throw TooManyHalfCycles::under_excitation(static_cast<double>(most_passages_ + 1),
                                                static_cast<double>(s_.now.value() / map_.p));
    }
  }

  /// So many more are allowed.
  [[nodiscard]] double passages_left() const {
    return static_cast<double>(most_passages_ - s_.passages);
  }

  /// That many more are certain.
  void require_passages(const Real& more) const {
    const double all = static_cast<double>(s_.passages) + static_cast<double>(more);
    if (all > static_cast<double>(most_passages_)) {
      throw TooManyHalfCycles::at_least(all, static_cast<double>(most_passages_ + 1));
    }
  }

  /// The same on a piece that begins now, where no notch is.
  template <class Piece, class AnyCrossing>
  void cross(const Piece& piece, const typename Piece::End& end, std::optional<AnyCrossing>& last) {
    pass();
    last.emplace(piece, end);
    watch_crossing(*last);
  }

  /// Where the motion begins or continues, in its own direction.
  [[nodiscard]] Sliding<Real> own_direction(const Real& w) const {
    const Real sign(s_.direction);
    const Real y = sign * s_.u;
    const Real v = sign * s_.v;
    if (s_.first_acceleration) {
      return {y, v, *s_.first_acceleration, s_.direction};
    }
    Real pull = y + sign * w + law_.phi_ahead(y);
    if constexpr (Law::damped) {
      pull += law_.drag(v);
    }
    return {y, v, Real(-pull), s_.direction};
  }

 private:
  void come_to_rest() {
    s_.v = Real(0);
    if constexpr (!Law::in_zones) {
      slides(s_, law_);  // in zones each piece has its own friction
    }
    s_.mode = ForcedMode::resting;
    s_.fresh = true;
    s_.rest_begin = s_.now;
    law_.rest();
  }

  /// Rule 4.
  void begin(const BasicStart<Real>& start) {
    s_.u = map_.p * start.x0;
    s_.v = start.v0;
    s_.farthest = magnitude(s_.u);
    const Real energy = s_.v * s_.v;
    const bool notched = s_.u == 0 && s_.v != 0 && map_.notch > 0;
    if (notched) {
      s_.margin.decide(magnitude(Real(energy - map_.notch)), energy + map_.notch);
    }
    if (notched && map_.catches(s_.v)) {
      s_.jump = magnitude(s_.v);
      s_.v = Real(0);
      s_.caught = true;
      if (!law_.lets_go()) {
        s_.mode = ForcedMode::over;
        s_.outcome = Outcome::caught_at_start;
      }
    } else if (s_.v != 0) {
      s_.mode = ForcedMode::sliding;
      s_.direction = s_.v > 0 ? 1 : -1;
      s_.moved = true;
      slides(s_, law_);
    }
    event(EventKind::start);
  }

  template <class Drive>
  void slide(Drive& drive, ExactSum<Real>& left, std::optional<CrossingUnder<Drive>>& last) {
    if constexpr (Law::in_zones) {
      slide_in_zone(*this, drive, left, last);
      return;
    }
    const Sliding<Real> from = own_direction(drive.w());
    auto piece = this->piece(drive, from);
    const bool inward = from.y < 0;
    auto end = piece.first_event(left.value(), inward && map_.notch > 0);
    if (end.event == PieceEvent::none && !(end.at.v > 0)) {
      end.event = PieceEvent::turn;  // within rounding of the end of the drive
    }
    s_.acceleration = piece.largest_acceleration(end, s_.acceleration);
    if constexpr (Watcher::watches) {
      watcher_.piece(s_.now, from.direction, piece, end.h, drive.w());
    }
    if (map_.notch == 0 && inward &&
        (end.at.y > 0 || (end.at.y == 0 && end.event != PieceEvent::turn))) {
      cross(piece, end, last);
    }
    left.add(-end.h);
    s_.now.add(end.h);
    drive.advance_to(end, from.direction);
    s_.first_acceleration.reset();
    s_.u = Real(from.direction) * end.at.y;
    s_.v = Real(from.direction) * end.at.v;
    if (end.event == PieceEvent::arrival) {
      decide_arrival_before_change(*this, drive.w(), left.value());
      arrive();
    } else if (end.event == PieceEvent::turn) {
      turn();
    } else if (end.event == PieceEvent::touch) [[unlikely]] {
      touch(*this, drive, left);
    }
  }

  /// Pieces end at 2 pi, with damping at 2 pi / omega.
  [[nodiscard]] Real longer_than_a_piece() const {
    if constexpr (Law::damped) {
      return 8 / law_.swing().omega();
    } else {
      return Real(8);
    }
  }

  template <class AnyCrossing>
  void watch_crossing(const AnyCrossing& crossing) {
    if constexpr (Watcher::watches) {
      const auto at_zero = crossing.piece.arrival_before(crossing.end);
      ExactSum<Real> when = s_.now;
      when.add(at_zero.h);
      const Real v = Real(s_.direction) * at_zero.at.v;
      watcher_.event(EventKind::arrival, when, Real(0), v);
      watcher_.event(EventKind::passage, when, Real(0), v);
    }
  }

  HalfCycleMap<Real> map_;
  Law law_;
  Watcher& watcher_;
  Patience patience_;
  std::int64_t most_passages_{std::numeric_limits<std::int64_t>::max()};
  ForcedState<Real> s_;
};

}  // namespace stillpoint
