// SPDX-License-Identifier: MIT
#include "kernel/exact_sum.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/linear_piece.hpp"
#include "sampling.hpp"
#include "watched_motion.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <type_traits>
#include <variant>

namespace stillpoint {

/// The motion between two events.
class ForcedTrajectory::Pieces {
 public:
  struct Rest {
    double u;
  };
  using Motion = std::variant<Rest, HarmonicFlow<double>, LinearPiece<double>, DampedPiece<double>,
                              DampedCurve<double>>;
  struct Piece {
    ExactSum<double> begin;  ///< p tau
    int direction;
    Motion motion;
  };

  Pieces(double p, std::int64_t most) : p_(p), most_(most) {}

  [[nodiscard]] double p() const { return p_; }

  void add(const Piece& piece, double t_end) {
    if (static_cast<std::int64_t>(pieces_.size()) >= most_) {
      throw InputError(
          "t_end", t_end,
          fmt::format("the motion up to that time has more than {} pieces, too many for a "
                      "trajectory",
                      most_));
    }
    pieces_.push_back(piece);
  }

  [[nodiscard]] State at(double tau) const {
    const double phase = p_ * tau;
    const auto after = std::ranges::upper_bound(
        pieces_, phase, {}, [](const Piece& later) { return later.begin.high(); });
    assert(after != pieces_.begin());
    const Piece& piece = *std::prev(after);
    const double h = std::max(ExactSum<double>::product(p_, tau).minus(piece.begin), 0.0);
    const double sign = piece.direction;
    const auto state = [&](const auto& motion) -> State {
      if constexpr (std::is_same_v<std::decay_t<decltype(motion)>, Rest>) {
        return {tau, motion.u / p_, 0};
      } else {
        const auto point = motion.at(h);
        return {tau, sign * point.y / p_, sign * point.v};
      }
    };
    return std::visit(state, piece.motion);
  }

 private:
  double p_;
  std::int64_t most_;
  std::vector<Piece> pieces_;
};

/// Records what the run reports.
class ForcedTrajectory::Watcher final : public MotionWatcher {
 public:
  Watcher(ForcedTrajectory& path, Pieces& pieces) : path_(path), pieces_(pieces) {}

  void event(EventKind kind, const ExactSum<double>& now, double u, double v) override {
    const Event event{kind,
                      {std::min(now.value() / pieces_.p(), path_.horizon_), u / pieces_.p(), v}};
    // Only the end of the excitation may show that a rest is final.
    const auto later =
        std::upper_bound(path_.events_.begin(), path_.events_.end(), event,
                         [](const Event& a, const Event& b) { return a.state.tau < b.state.tau; });
    path_.events_.insert(later, event);
    const bool rests = kind == EventKind::stick || kind == EventKind::rest;
    if (rests || kind == EventKind::start) {
      keep({now, 1, Pieces::Rest{u}});
    }
  }

  void follow(const WatchedPiece& piece) override {
    const auto copy = [](const auto* motion) { return Pieces::Motion(*motion); };
    keep({piece.begin, piece.direction, std::visit(copy, piece.motion)});
  }

 private:
  void keep(const Pieces::Piece& piece) { pieces_.add(piece, path_.horizon_); }

  ForcedTrajectory& path_;
  Pieces& pieces_;
};

ForcedTrajectory::ForcedTrajectory(const Oscillator& oscillator, const Start& start,
                                   const Excitation& excitation,
                                   const ForcedTrajectoryOptions& options, const Surface& surface)
    : horizon_(options.horizon) {
  require_valid(oscillator, start, excitation, options.horizon);
  require_valid(oscillator, surface);
  const double p = oscillator.p;
  const auto pieces = std::make_shared<Pieces>(p, options.pieces);
  pieces_ = pieces;
  Watcher watcher(*this, *pieces);
  const ForcedState<double> state =
      watched_motion(oscillator, surface, start, excitation,
                     {.t_end = options.horizon, .go_on = options.go_on}, watcher);
  if (options.to_rest && state.outcome && state.rest_begin.value() > 0) {
    horizon_ = state.rest_begin.value() / p;
    std::erase_if(events_, [this](const Event& event) { return event.state.tau > horizon_; });
  }
  if (!state.outcome) {
    events_.push_back({EventKind::end, {horizon_, state.u / p, state.v}});
  }
}

State ForcedTrajectory::at(double tau) const {
  require_within("tau", tau, 0, horizon_);
  const auto event = std::ranges::upper_bound(events_, tau, {},
                                              [](const Event& later) { return later.state.tau; });
  assert(event != events_.begin());
  const Event& before = *std::prev(event);
  if (before.state.tau == tau) {
    return {tau, before.state.x, before.state.v};
  }
  return pieces_->at(tau);
}

std::vector<State> ForcedTrajectory::sampled(std::int64_t samples) const {
  return sampled_states(*this, samples);
}

}  // namespace stillpoint
