// SPDX-License-Identifier: MIT
#include "motion_watchers.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/half_cycles.hpp>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace stillpoint {

namespace {

/// Builds half-cycles from the events it sees.
class HalfCycleWatcher final : public Finder<std::vector<HalfCycle>> {
 public:
  /// `notch` is 2 delta at x = 0; empty where the notch has a width.
  HalfCycleWatcher(double p, std::optional<double> notch, std::int64_t most)
      : p_(p), notch_(notch), most_(most) {}

  void event(EventKind kind, const ExactSum<double>& now, double u, double v) override {
    const double tau = now.value() / p_;
    reach(tau, u);
    switch (kind) {
      case EventKind::start:
        now_.departure_speed = std::abs(v);
        break;
      case EventKind::turn:
        moved_ = true;
        break;
      case EventKind::release:
        begin_late(tau, std::abs(v));
        break;
      case EventKind::arrival:
        moved_ = true;
        now_.arrival_speed = std::abs(v);
        arrival_ = tau;
        break;
      case EventKind::passage:
        feel_the_notch(std::abs(v));
        close(arrival_, 0);
        now_.start_time = now_.peak_time = tau;  // later, where the notch held the mass for a while
        now_.departure_speed = std::abs(v);
        break;
      case EventKind::rest:
        finish(tau, u);
        break;
      default:
        break;
    }
  }

  void end(const ForcedState<double>& state) override {
    if (state.moved) {
      finish(state.now.value() / p_, state.u);
    } else {
      list_.clear();
    }
  }

  [[nodiscard]] bool full() const override {
    return static_cast<std::int64_t>(list_.size()) >= most_;
  }

  [[nodiscard]] std::vector<HalfCycle> found() override { return std::move(list_); }

 private:
  /// The half-cycle that is under way when the motion ends or the run stops.
  void finish(double tau, double u) {
    if (!over_) {
      reach(tau, u);
      now_.last = over_ = true;
      feel_the_notch(0);
      close(now_.arrival_speed ? arrival_ : tau, u / p_);  // a notch may still hold it at the end
    }
  }

  void reach(double tau, double u) {
    const double x = std::abs(u) / p_;
    if (x > now_.peak) {
      now_.peak = x;
      now_.peak_time = tau;
      now_.side = u > 0 ? 1 : -1;
    }
  }

  /// A mass that was held from its start begins to move when the load frees it.
  void begin_late(double tau, double v) {
    if (!moved_) {
      now_.start_time = now_.peak_time = tau;
      now_.departure_speed = v;
      moved_ = true;
    }
  }

  /// A mass that left the notch later had stopped in it first.
  void feel_the_notch(double departure) {
    if (notch_ && now_.arrival_speed) {
      now_.impulse =
          departure > 0 ? *notch_ / (*now_.arrival_speed + departure) : *now_.arrival_speed;
    }
  }

  void close(double tau, double position) {
    now_.end_time = tau;
    now_.end_position = position;
    if (!full()) {
      list_.push_back(now_);
    }
    const std::int64_t next = now_.index + 1;
    const int side = -now_.side;
    now_ = {};
    now_.index = next;
    now_.side = side;
    now_.start_time = now_.peak_time = tau;
  }

  double p_;
  std::optional<double> notch_;
  std::int64_t most_;
  double arrival_{0};  ///< tau of the last arrival at x = 0
  bool moved_{false};  ///< since the start
  bool over_{false};
  HalfCycle now_;
  std::vector<HalfCycle> list_;
};

}  // namespace

std::unique_ptr<Finder<std::vector<HalfCycle>>> half_cycle_watcher(const Oscillator& oscillator,
                                                                   const Surface& surface,
                                                                   std::int64_t most) {
  const auto notch =
      surface.notch_width ? std::nullopt : std::optional<double>(2 * oscillator.delta);
  return std::make_unique<HalfCycleWatcher>(oscillator.p, notch, most);
}

std::vector<HalfCycle> forced_half_cycles(const Oscillator& oscillator, const Start& start,
                                          const Excitation& excitation, double t_end,
                                          std::int64_t most,
                                          const std::function<bool(double)>& go_on,
                                          const Surface& surface) {
  const auto watcher = half_cycle_watcher(oscillator, surface, most);
  WatchedOptions options{{.t_end = t_end, .go_on = go_on}};
  options.listing = {watcher.get()};
  watched_motion(oscillator, surface, start, excitation, options);
  return watcher->found();
}

}  // namespace stillpoint
