// SPDX-License-Identifier: MIT
#include "kernel/exact_sum.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/linear_piece.hpp"
#include "motion_watchers.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <type_traits>
#include <variant>

namespace stillpoint {

namespace {

/// A forced motion between its events.
class Pieces {
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

  explicit Pieces(double p) : p_(p) {}

  [[nodiscard]] double p() const { return p_; }
  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(pieces_.size()); }
  void add(const Piece& piece) { pieces_.push_back(piece); }

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
  std::vector<Piece> pieces_;
};

/// Records what the run reports.
class PathWatcher final : public Finder<Path> {
 public:
  PathWatcher(double p, std::int64_t most, bool to_rest)
      : pieces_(std::make_shared<Pieces>(p)), most_(most), to_rest_(to_rest) {}

  void set_horizon(double tau) override {
    horizon_ = tau;
    refuse_too_many();
  }

  void event(EventKind kind, const ExactSum<double>& now, double u, double v) override {
    const Event event{kind, {std::min(now.value() / pieces_->p(), horizon_), u / pieces_->p(), v}};
    // Only the end of the excitation may show that a rest is final.
    const auto later =
        std::upper_bound(events_.begin(), events_.end(), event,
                         [](const Event& a, const Event& b) { return a.state.tau < b.state.tau; });
    events_.insert(later, event);
    const bool rests = kind == EventKind::stick || kind == EventKind::rest;
    if (rests || kind == EventKind::start) {
      keep({now, 1, Pieces::Rest{u}});
    }
  }

  void follow(const WatchedPiece& piece) override {
    const auto copy = [](const auto* motion) { return Pieces::Motion(*motion); };
    keep({piece.begin, piece.direction, std::visit(copy, piece.motion)});
  }

  void end(const ForcedState<double>& state) override {
    const double p = pieces_->p();
    if (to_rest_ && state.outcome && state.rest_begin.value() > 0) {
      horizon_ = state.rest_begin.value() / p;
      std::erase_if(events_, [this](const Event& event) { return event.state.tau > horizon_; });
    }
    if (!state.outcome) {
      events_.push_back({EventKind::end, {horizon_, state.u / p, state.v}});
    }
  }

  [[nodiscard]] Path found() override {
    return {horizon_, std::move(events_),
            [pieces = pieces_](double tau) { return pieces->at(tau); }};
  }

 private:
  void keep(const Pieces::Piece& piece) {
    too_many_ = too_many_ || pieces_->size() >= most_;
    if (!too_many_) {
      pieces_->add(piece);
    }
    refuse_too_many();
  }

  /// The refusal names the horizon, so it waits until that is known.
  void refuse_too_many() const {
    if (too_many_ && horizon_ < HUGE_VAL) {
      throw InputError("t_end", horizon_,
                       fmt::format("the motion up to that time has more than {} pieces, too many "
                                   "for a trajectory",
                                   most_));
    }
  }

  double horizon_{HUGE_VAL};
  std::vector<Event> events_;
  std::shared_ptr<Pieces> pieces_;
  std::int64_t most_;
  bool to_rest_;
  bool too_many_{false};
};

Path followed(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
              const ForcedTrajectoryOptions& options, const Surface& surface) {
  PathWatcher watcher(oscillator.p, options.pieces, options.to_rest);
  WatchedOptions wanted{{.t_end = options.horizon, .go_on = options.go_on}};
  wanted.listing = {&watcher};
  watched_motion(oscillator, surface, start, excitation, wanted);
  return watcher.found();
}

}  // namespace

std::unique_ptr<Finder<Path>> path_watcher(const Oscillator& oscillator, std::int64_t pieces,
                                           bool to_rest) {
  return std::make_unique<PathWatcher>(oscillator.p, pieces, to_rest);
}

ForcedTrajectory::ForcedTrajectory(const Oscillator& oscillator, const Start& start,
                                   const Excitation& excitation,
                                   const ForcedTrajectoryOptions& options, const Surface& surface)
    : Path(followed(oscillator, start, excitation, options, surface)) {}

}  // namespace stillpoint
