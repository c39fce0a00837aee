// SPDX-License-Identifier: MIT
#include "watched_motion.hpp"

#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/on_surface.hpp"
#include "response_of_run.hpp"

#include <algorithm>
#include <map>

namespace stillpoint {

namespace {

/// Those that watch now.
struct WatcherPack {
  static constexpr bool watches = true;

  void event(EventKind kind, const ExactSum<double>& now, double u, double v) {
    tell([&](MotionWatcher& each) { each.event(kind, now, u, v); });
  }

  template <class Piece>
  void piece(const ExactSum<double>& begin, int direction, const Piece& piece, double length,
             double load) {
    if constexpr (requires { piece.flow(); }) {
      follow({begin, direction, length, load, &piece.flow()});
    } else {
      follow({begin, direction, length, load, &piece});
    }
  }

  void follow(const WatchedPiece& piece) {
    tell([&](MotionWatcher& each) { each.follow(piece); });
  }

  void set_horizon(double tau) {
    tell([&](MotionWatcher& each) { each.set_horizon(tau); });
  }

  void end(const ForcedState<double>& state) {
    tell([&](MotionWatcher& each) { each.end(state); });
  }

  [[nodiscard]] bool full() const {
    return std::ranges::all_of(watching, [](const MotionWatcher* each) { return each->full(); });
  }

  template <class Told>
  void tell(const Told& told) {
    std::ranges::for_each(watching, [&](MotionWatcher* each) { told(*each); });
  }

  MotionWatchers watching;
};

/// One run, and what is wanted of it.
class WatchedRun {
 public:
  WatchedRun(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
             const WatchedOptions& options, WatcherPack& pack)
      : oscillator_(oscillator),
        start_(start),
        excitation_(excitation),
        options_(options),
        pack_(pack) {}

  /// Asked now and then.
  bool goes_on(double tau) {
    cancelled_ = cancelled_ || (options_.go_on && !options_.go_on(tau));
    return !cancelled_ && (response_is_due_ || !pack_.full());
  }

  template <class Run>
  ForcedResponse of(Run& run) {
    response_is_due_ = options_.response;
    if (response_is_due_) {
      prepare(run, oscillator_, excitation_, options_);
    } else {
      limit(run, options_);
    }
    std::visit([&](const auto& kind) { options_.t_end ? to_t_end(run, kind) : to_rest(run, kind); },
               excitation_);
    response_.cancelled = cancelled_;
    return response_;
  }

 private:
  template <class Run, class Kind>
  void to_t_end(Run& run, const Kind& kind) {
    pack_.set_horizon(*options_.t_end);
    run_until(run, kind, *options_.t_end);
    finish(run, *options_.t_end);
  }

  template <class Run, class Kind>
  void to_rest(Run& run, const Kind& kind) {
    const Load<double> load = run.over() ? Load<double>() : excite_whole(run, kind);
    const ForcedState<double> state = run.state();
    const auto law = run.law();
    pack_.watching = options_.to_end;
    to_free_turn(run, load);
    finish(run, duration_of<double>(kind));
    std::map<double, MotionWatchers> listings;
    for (MotionWatcher* each : options_.listing) {
      listings[cancelled_ ? 0 : options_.horizon(*each, response_)].push_back(each);
    }
    response_is_due_ = false;
    for (const auto& [horizon, watchers] : listings) {
      run.state() = state;
      run.state().transmitted.largest_load = nullptr;
      run.law() = law;
      run.allow_half_cycles(no_limit);
      pack_.watching = watchers;
      if (!cancelled_) {
        require_valid(oscillator_, start_, excitation_, horizon);
        pack_.set_horizon(horizon);
        free_until(run, load, ExactSum<double>::product(oscillator_.p, horizon));
      }
      pack_.end(run.state());
    }
  }

  /// At the end of the run, or where the motion goes on free.
  template <class Run>
  void finish(Run& run, double end) {
    pack_.end(run.state());
    if (options_.response) {
      response_ = response_to(run, end, oscillator_, options_);
    }
  }

  static constexpr double no_limit = 1e18;

  const Oscillator& oscillator_;
  const Start& start_;
  const Excitation& excitation_;
  const WatchedOptions& options_;
  WatcherPack& pack_;
  ForcedResponse response_;
  bool response_is_due_{false};
  bool cancelled_{false};
};

}  // namespace

ForcedResponse watched_motion(const Oscillator& oscillator, const Surface& surface,
                              const Start& start, const Excitation& excitation,
                              const WatchedOptions& options) {
  require_valid(oscillator, start, excitation, options.t_end);
  require_valid(oscillator, surface);
  WatcherPack pack{options.to_end};
  pack.watching.insert(pack.watching.end(), options.listing.begin(), options.listing.end());
  WatchedRun wanted(oscillator, start, excitation, options, pack);
  const Patience patience([&](double tau) { return wanted.goes_on(tau); }, options.ask_every);
  return on_surface(oscillator, surface, start, pack, patience,
                    [&](auto& run) { return wanted.of(run); });
}

}  // namespace stillpoint
