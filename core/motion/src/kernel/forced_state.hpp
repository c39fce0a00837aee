// SPDX-License-Identifier: MIT
#pragma once

// The state and the metrics of a forced run. Units and symbols as in forced_run.hpp.

#include "kernel/exact_sum.hpp"
#include "kernel/piece_end.hpp"
#include "kernel/transmitted.hpp"

#include <stillpoint/core/state.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace stillpoint {

/// Sees nothing: for a run that needs only metrics.
struct NoWatcher {
  static constexpr bool watches = false;
};

enum class ForcedMode {
  sliding,  ///< v has the sign of the direction, or leaves rest in it
  resting,  ///< v = 0; the load decides for how long
  over,     ///< at rest for ever, or told to end
};

/// The whole state of a forced run, in the units above.
template <class Real>
struct ForcedState {
  ForcedMode mode{ForcedMode::resting};
  std::optional<Outcome> outcome;  ///< once it is final
  Real u{0};
  Real v{0};
  int direction{1};
  std::optional<Real> first_acceleration;  ///< as it leaves rest; 0 at a release
  bool fresh{true};                        ///< at rest since this very instant
  ExactSum<Real> now;
  ExactSum<Real> rest_begin;
  Real slide_begin{0};  ///< of the last slide, rounded

  bool moved{false};
  bool caught{false};  ///< at the start, by the notch
  std::int64_t passages{0};
  std::int64_t turning_points{0};
  std::int64_t sticks{0};
  ExactSum<Real> stuck;               ///< for how long, in all
  Real farthest{0};                   ///< largest |u| at events
  Real acceleration{0};               ///< largest |x''| / p
  std::optional<Real> arrival_speed;  ///< at the last arrival at x = 0
  Real jump{0};                       ///< largest |v-| - |v+| at x = 0
  bool left_notch_from_rest{false};   ///< rule 4: left x = 0 from rest although Delta > 0
  Transmitted<Real> transmitted;
  TippingMargin<Real> margin;
};

/// Asks go_on every n-th piece; never, if there is none.
class Patience {
 public:
  Patience() = default;
  Patience(std::function<bool(double)> go_on, int every)
      : go_on_(std::move(go_on)), every_(every), left_(every) {}

  /// Once per piece. `tau` returns the time reached, and is called only if needed.
  template <class Time>
  bool lasts(Time tau) {
    if (!go_on_ || --left_ > 0) {
      return true;
    }
    left_ = every_;
    ended_ = ended_ || !go_on_(tau());
    return !ended_;
  }

  [[nodiscard]] bool ended() const { return ended_; }

 private:
  std::function<bool(double)> go_on_;
  int every_{1};
  int left_{1};
  bool ended_{false};
};

}  // namespace stillpoint
