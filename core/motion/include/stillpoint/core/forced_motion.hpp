// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <functional>
#include <optional>
#include <string>

namespace stillpoint {

struct ForcedOptions {
  /// The tau at which the run ends. Without it the run continues to the end of the free motion
  /// after the excitation; it is required if the excitation never ends.
  std::optional<double> t_end{};
  /// A motion with more half-cycles is refused, unless it is a closed form (a single friction). If
  /// empty, only a free motion after the excitation has a limit, that of FreeOptions, and only
  /// without t_end.
  std::optional<double> half_cycle_limit{};
  /// Called now and then with the tau reached; returning false ends the run there.
  std::function<bool(double)> go_on{};
  int ask_every{1024};  ///< pieces between two calls; >= 1
};

/// The metrics of a forced motion. Those of Response mean the same; if the outcome is `running`,
/// the counts are those up to end_time.
struct ForcedResponse : Response {
  /// The tau where the run ended: t_end, or the stop_time. Empty if the motion never stops and no
  /// t_end was given; so are the next two.
  std::optional<double> end_time{};
  std::optional<double> final_position{};
  std::optional<double> final_velocity{};
  /// Rests of positive length in which friction holds the mass for a while. One cut short by the
  /// end of the run counts; a final rest does not.
  double sticks{0};
  double stick_time{0};  ///< their total length in tau
  /// The mass left rest at x = 0 although delta > 0: the notch acts from the first return on. One
  /// with a finite hold or a width acts from the beginning, so that this is false.
  bool left_notch_from_rest{false};
  /// The tau from which the notch holds the mass at x = 0 although W goes on: since it came there,
  /// or since the start. Empty if it does not, or if W is 0 from then on; so is the next.
  std::optional<double> locked_from{};
  std::optional<double> largest_load_while_locked{};  ///< |W| in g, which the structure then feels
  bool cancelled{false};                              ///< go_on returned false

  [[nodiscard]] bool locks() const { return locked_from.has_value(); }
  [[nodiscard]] bool operator==(const ForcedResponse&) const = default;
};
// decision_margin here: the smallest relative distance of a compared quantity from what it was
// compared with, at the instant of the decision. Unlike that of a free motion it does not refer to
// the inputs; docs/forced.md section 7 says which decisions count.

/// The motion of `oscillator` from `start` under `excitation`, exact except for rounding: no step
/// size and no tolerance. Throws InputError for wrong input, and TooManyHalfCycles as free_response
/// does if the motion continues free. docs/forced.md; on another surface docs/notches.md.
[[nodiscard]] ForcedResponse forced_response(const Oscillator& oscillator, const Start& start,
                                             const Excitation& excitation,
                                             const ForcedOptions& options = {},
                                             const Surface& surface = {});

/// As for a Response; for a motion that is still running it says where the mass is.
[[nodiscard]] std::string summary(const ForcedResponse& response);

/// The input of a forced run: what require_valid says of each part, and
///   |k| / p and record values / p are 0 or within [1e-150, 1e150], lambda / p within [1e-12,
///   1e12], 0 < t_end, and p t_end and lambda t_end are at most 1e15.
void require_valid(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
                   const std::optional<double>& t_end);

}  // namespace stillpoint
