// SPDX-License-Identifier: MIT
#pragma once

// A sliding piece where friction steps with |x|: up to the next edge. docs/notches.md section 3.
// x = 0 is one only with a notch there; else it is passed on the way, and counted. The piece is
// that of constant friction, with the edge as its origin: its acceleration knows the friction and
// the spring.

#include "kernel/certain_passages.hpp"
#include "kernel/drives.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/forced_state.hpp"
#include "kernel/functions.hpp"
#include "kernel/piece_end.hpp"
#include "kernel/touch.hpp"

#include <stillpoint/core/state.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace stillpoint {

/// The mass has come to an edge with its v.
template <class Run>
void reach_edge(Run& run) {
  auto& s = run.state();
  if (s.u == 0) {
    run.arrive();
    return;
  }
  const auto energy = decltype(s.v)(s.v * s.v);
  s.margin.decide(energy, decltype(s.v)(energy + s.farthest * s.farthest));
  if (s.v == 0) {
    run.turn();
  }
}

/// Under a constant load a piece without damping has a closed form.
template <class Drive, class Piece, class Real>
auto first_event_under(Drive& drive, Piece& piece, const Real& limit, bool want_arrival) {
  if constexpr (requires { drive.first_event(piece, limit, want_arrival); }) {
    return drive.first_event(piece, limit, want_arrival);
  } else {
    return piece.first_event(limit, want_arrival);
  }
}

/// A near edge is reached after about the time that it takes at this acceleration, a far one after
/// that of the last far one: a drive that guesses keeps the two apart.
template <class Drive, class Piece, class Real>
auto first_event_in_zone(Drive& drive, Piece& piece, const Sliding<Real>& from, const Real& limit,
                         bool edge_ahead) {
  if constexpr (requires { drive.expects_arrival_after(Real()); }) {
    using std::sqrt;
    const Real square = from.v * from.v - 2 * from.a * from.y;
    if (edge_ahead && from.v > 0 && square > 0) {
      const Real expected = -2 * from.y / (from.v + sqrt(square));
      const Real near(0.25);  // of 1/p: there the acceleration has hardly changed
      if (expected < near) {
        const Real far = drive.expects_arrival_after(expected);
        auto end = first_event_under(drive, piece, limit, edge_ahead);
        drive.expects_arrival_after(far);
        return end;
      }
    }
  }
  return first_event_under(drive, piece, limit, edge_ahead);
}

/// Where a piece ends that stays near x = 0. As seen from a far edge it would lose its digits; from
/// nearer ones, at most ten bits, sums of decimal inputs stay what they are, as ties need.
template <class Real, class Run, class Drive>
[[gnu::noinline]] Real end_near_zero(const Run& run, Drive& drive, const Sliding<Real>& whole,
                                     const Real& h) {
  const auto piece = run.piece(drive, whole);
  if constexpr (requires { piece.flow(); }) {
    return piece.flow().at(h).y;
  } else {
    return piece.at(h).y;
  }
}

/// Counts x = 0 where the piece ends at `y`, beyond it.
template <class Run, class Drive, class Real, class End, class AnyCrossing>
void pass_zero(Run& run, Drive& drive, const Sliding<Real>& whole, End end, const Real& y,
               std::optional<AnyCrossing>& last) {
  if (whole.y < 0 && run.map().notch == 0 && (y > 0 || (y == 0 && end.event != PieceEvent::turn))) {
    end.at.y = y;
    run.cross(run.piece(drive, whole), end, last);
  }
}

template <class Run, class Drive, class Real>
void slide_in_zone(Run& run, Drive& drive, ExactSum<Real>& left,
                   std::optional<typename Run::template CrossingUnder<Drive>>& last) {
  ForcedState<Real>& s = run.state();
  const Sliding<Real> whole = run.own_direction(drive.w());
  const Real edge = run.law().edge_ahead(whole.y);
  const bool edge_ahead = edge < std::numeric_limits<Real>::max();
  Sliding<Real> from = whole;
  if (edge_ahead) {
    from.y -= edge;
  }
  auto piece = run.piece(drive, from);
  auto end = first_event_in_zone(drive, piece, from, left.value(), edge_ahead);
  if (end.event == PieceEvent::none && !(end.at.v > 0)) {
    end.event = PieceEvent::turn;  // within rounding of the end of the drive
  }
  s.acceleration = piece.largest_acceleration(end, s.acceleration);
  const Real phi = run.law().phi_ahead(whole.y);
  if constexpr (Run::AnyLaw::damped) {
    s.transmitted.slid =
        piece.largest_transmitted(Real(phi + (whole.y - from.y)), end, s.transmitted.slid);
  } else {
    s.transmitted.slides(whole.y, phi);
  }
  if constexpr (Run::AnyWatcher::watches) {
    run.watcher().piece(s.now, whole.direction, run.piece(drive, whole), end.h, drive.w());
  }
  Real y = end.at.y;
  if (end.event == PieceEvent::arrival) {
    y = edge;
  } else if (edge_ahead) {
    y += edge;
    if (magnitude(y) < magnitude(edge) / 1024) {
      y = end_near_zero(run, drive, whole, end.h);
    }
  }
  pass_zero(run, drive, whole, end, y, last);
  left.add(-end.h);
  s.now.add(end.h);
  drive.advance_to(end, from.direction);
  s.first_acceleration.reset();
  const Real sign(from.direction);
  if (end.event == PieceEvent::arrival) {
    s.u = edge == 0 ? Real(0) : Real(sign * edge);
    s.v = end.at.v > 0 ? Real(sign * end.at.v) : Real(0);
    if constexpr (!Run::AnyLaw::damped) {
      s.transmitted.slides(edge, phi);
    }
    run.law().reach(edge);
    reach_edge(run);
    return;
  }
  s.u = sign * y;
  s.v = sign * end.at.v;
  if (!Run::AnyLaw::damped || end.event == PieceEvent::turn) {
    s.transmitted.slides(Real(sign * s.u), phi);
  }
  if (end.event == PieceEvent::turn) {
    run.turn();
  } else if (end.event == PieceEvent::touch) {
    touch(run, drive, left);
  }
}

/// A motion that W = 0 leaves free, at a turn: refused here if the limit is certain to be exceeded.
template <class Run>
void require_few_passages(const Run& run, [[maybe_unused]] bool first) {
  const auto& u = run.state().u;
  const auto& notch = run.map().notch;
  using Real = std::decay_t<decltype(u)>;
  const Real end = run.law().farthest_end(u);
  if constexpr (Run::AnyLaw::damped) {
    if (first) {
      const auto taken = [&](double of) {
        return static_cast<double>(run.law().most_taken(Real(of)));
      };
      run.require_passages(Real(certain_passages(
          static_cast<double>(magnitude(u)), static_cast<double>(end), static_cast<double>(notch),
          static_cast<double>(run.law().zeta()), run.passages_left(), taken)));
    }
  } else {
    const Real left = std::max(Real(end * end), notch);
    run.require_passages(Real((u * u - left) / (notch + run.law().most_taken(u)) - 1));
  }
}

/// W = 0 for good: up to the final rest, or until nothing can slow the mass down any more.
template <class Run, class Drive>
void slide_to_rest(Run& run, Drive& drive) {
  std::optional<std::decay_t<decltype(run.state().u)>> set_off_from;
  while (!run.over()) {
    run.slide_to_turn(drive);
    run.settle();
    if (!run.over() && set_off_from == run.state().u) {
      // Beyond the dead zone by so little that no digit of u changes: for ever, if it went on.
      run.stop_where_it_rests();
    }
    if (!run.over() && run.law().frictionless_up_to(run.state().u)) {
      auto& s = run.state();
      s.mode = ForcedMode::over;
      s.outcome = Outcome::never_stops;
      // A mass that starts at rest has not felt yet what it will feel at every turn.
      s.acceleration = std::max(s.acceleration, magnitude(s.u));
      s.transmitted.slides(s.u, decltype(s.u)(0));
    }
    if (!run.over()) {
      require_few_passages(run, !set_off_from);
      set_off_from = run.state().u;
      run.set_off_under(drive);
    }
  }
}

}  // namespace stillpoint
