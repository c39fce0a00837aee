// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/state.hpp>
#include <stillpoint/records/units.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace stillpoint::sweep {

/// What a sweep varies and what it computes: the columns of its output, in their order. A grid
/// varies its axes in this order too, the last one fastest.
enum class Quantity : std::uint8_t {
  v0,
  v0_low,
  p,
  p_high,
  x0,
  k,
  k_low,
  lambda,
  lambda_high,
  beta,
  residual,
  arrivals,
  trade_off,
  feasible,
  f,
  delta,
  hold,
  notch_width,
  tolerance,
  arrival,
  peak_amplitude,
  half_cycles,
  outcome,
  stop_position,
  stop_time,
  end_time,
  final_position,
  final_velocity,
  sticks,
  stick_time,
  peak_absolute_acceleration,
  locked_from,
  largest_load_while_locked,
};

/// How a quantity is written. In memory all are doubles.
enum class Form : std::uint8_t {
  number,   ///< NaN: does not exist; infinite: never happens. Both are empty in CSV
  outcome,  ///< see sweep_outcome_name; its name in CSV
  truth,    ///< 0 or 1
};

struct QuantityForm {
  Quantity quantity;
  std::string_view name;           ///< as in the reports and as an option
  std::string_view physical{};     ///< in metres and seconds; empty: the same
  records::Dimension dimension{};  ///< which it has then
  Form form{Form::number};
};

inline constexpr auto quantity_forms = [] {
  using records::Dimension;
  return std::to_array<QuantityForm>({
      {Quantity::v0, "v0", "velocity", Dimension::velocity},
      {Quantity::v0_low, "v0_low", "velocity_low", Dimension::velocity},
      {Quantity::p, "p"},
      {Quantity::p_high, "p_high"},
      {Quantity::x0, "x0", "x0_m", Dimension::length},
      {Quantity::k, "k"},
      {Quantity::k_low, "k_low"},
      {Quantity::lambda, "lambda"},
      {Quantity::lambda_high, "lambda_high"},
      {Quantity::beta, "beta", "max_displacement", Dimension::length},
      {Quantity::residual, "residual", "residual_m", Dimension::length},
      {Quantity::arrivals, "arrivals"},
      {Quantity::trade_off, "trade_off"},
      {Quantity::feasible, "feasible", "", Dimension::none, Form::truth},
      {Quantity::f, "f"},
      {Quantity::delta, "delta", "delta_m", Dimension::length},
      {Quantity::hold, "hold"},
      {Quantity::notch_width, "notch_width", "notch_width_m", Dimension::length},
      {Quantity::tolerance, "tolerance"},
      {Quantity::arrival, "arrival"},
      {Quantity::peak_amplitude, "peak_amplitude", "peak_m", Dimension::length},
      {Quantity::half_cycles, "half_cycles"},
      {Quantity::outcome, "outcome", "", Dimension::none, Form::outcome},
      {Quantity::stop_position, "stop_position", "stop_position_m", Dimension::length},
      {Quantity::stop_time, "stop_time", "stop_time_s", Dimension::time},
      {Quantity::end_time, "end_time", "end_time_s", Dimension::time},
      {Quantity::final_position, "final_position", "final_position_m", Dimension::length},
      {Quantity::final_velocity, "final_velocity", "final_velocity_m_per_s", Dimension::velocity},
      {Quantity::sticks, "sticks"},
      {Quantity::stick_time, "stick_time", "stick_time_s", Dimension::time},
      {Quantity::peak_absolute_acceleration, "peak_absolute_acceleration"},
      {Quantity::locked_from, "locked_from", "locked_from_s", Dimension::time},
      {Quantity::largest_load_while_locked, "largest_load_while_locked"},
  });
}();

inline constexpr std::size_t quantity_count = quantity_forms.size();

constexpr std::size_t index(Quantity quantity) {
  return static_cast<std::size_t>(quantity);
}
constexpr std::string_view name(Quantity quantity) {
  return quantity_forms[index(quantity)].name;
}
constexpr Form form(Quantity quantity) {
  return quantity_forms[index(quantity)].form;
}

constexpr bool contains(std::span<const Quantity> quantities, Quantity quantity) {
  return std::ranges::find(quantities, quantity) != quantities.end();
}

/// If an input is a range, the quantity of the end that does not stand for it.
constexpr std::optional<Quantity> other_end(Quantity quantity) {
  switch (quantity) {
    case Quantity::v0:
      return Quantity::v0_low;
    case Quantity::p:
      return Quantity::p_high;
    case Quantity::k:
      return Quantity::k_low;
    case Quantity::lambda:
      return Quantity::lambda_high;
    default:
      return std::nullopt;
  }
}

/// How an entry of a sweep ends, by number: an Outcome or too_many_half_cycles, whose byte in files
/// is older than stopped_in_notch.
inline constexpr std::size_t too_many_half_cycles =
    static_cast<std::size_t>(Outcome::stopped_in_notch);
inline constexpr std::size_t sweep_outcome_count = too_many_half_cycles + 2;

[[nodiscard]] constexpr std::size_t sweep_outcome(Outcome outcome) {
  const auto number = static_cast<std::size_t>(outcome);
  return number < too_many_half_cycles ? number : number + 1;
}

/// Empty for too_many_half_cycles.
[[nodiscard]] constexpr std::optional<Outcome> motion_outcome(std::size_t number) {
  return number == too_many_half_cycles  ? std::nullopt
         : number < too_many_half_cycles ? std::optional(static_cast<Outcome>(number))
                                         : std::optional(static_cast<Outcome>(number - 1));
}

/// The name in rows and reports.
[[nodiscard]] inline std::string_view sweep_outcome_name(std::size_t number) {
  const auto outcome = motion_outcome(number);
  return outcome ? name(*outcome) : "too_many_half_cycles";
}

}  // namespace stillpoint::sweep
