// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/records/units.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace stillpoint::sweep {

/// What a sweep varies and what it computes: the columns of its output, in their order. A grid
/// varies its axes in this order too, the last one fastest.
enum class Quantity : std::uint8_t {
  record,  ///< by its place among SweepSpec::records, from 0; its name in CSV
  record_scale,
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
  damping,
  breakaway,
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

/// Of a motion that never stops, a figure that does not exist is infinite if it never comes.
enum class Missing : std::uint8_t { absent, never };

/// A result of a motion, which a sweep writes.
template <class Member>
struct MotionColumn {
  Quantity quantity{};
  Member member;
  Missing missing{};
};
template <class Member>
MotionColumn(Quantity, Member, Missing = {}) -> MotionColumn<Member>;

/// In the order of their columns. A free motion has those of Response.
inline constexpr std::tuple motion_columns{
    MotionColumn{Quantity::peak_amplitude, &Response::peak_amplitude},
    MotionColumn{Quantity::half_cycles, &Response::half_cycles, Missing::never},
    MotionColumn{Quantity::outcome, &Response::outcome},
    MotionColumn{Quantity::stop_position, &Response::stop_position},
    MotionColumn{Quantity::stop_time, &Response::stop_time, Missing::never},
    MotionColumn{Quantity::end_time, &ForcedResponse::end_time, Missing::never},
    MotionColumn{Quantity::final_position, &ForcedResponse::final_position},
    MotionColumn{Quantity::final_velocity, &ForcedResponse::final_velocity},
    MotionColumn{Quantity::sticks, &ForcedResponse::sticks},
    MotionColumn{Quantity::stick_time, &ForcedResponse::stick_time},
    MotionColumn{Quantity::peak_absolute_acceleration, &Response::peak_absolute_acceleration},
    MotionColumn{Quantity::locked_from, &ForcedResponse::locked_from},
    MotionColumn{Quantity::largest_load_while_locked, &ForcedResponse::largest_load_while_locked}};

/// What fields<ForcedResponse> says of the column. In metres and seconds accelerations stay in g.
template <class Member>
constexpr QuantityForm form_of(const MotionColumn<Member>& column) {
  QuantityForm form{.quantity = column.quantity, .name = {}};
  for_each_field(fields<ForcedResponse>, [&]<class Get>(const Field<Get>& field) {
    if constexpr (std::is_same_v<Get, Member>) {
      if (field.get == column.member) {
        form.name = field.name;
        if (field.measure.dimension != records::Dimension::gravities) {
          form.physical = field.measure.physical;
          form.dimension = field.measure.dimension;
        }
      }
    }
  });
  if constexpr (std::is_same_v<Member, Outcome Response::*>) {
    form.form = Form::outcome;
  }
  return form;
}

inline constexpr auto quantity_forms = [] {
  using records::Dimension;
  constexpr auto others = std::to_array<QuantityForm>({
      {Quantity::record, "record"},
      {Quantity::record_scale, "record_scale"},
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
      {Quantity::damping, "damping"},
      {Quantity::breakaway, "breakaway"},
      {Quantity::tolerance, "tolerance"},
      {Quantity::arrival, "arrival"},
  });
  std::array<QuantityForm, others.size() + std::tuple_size_v<decltype(motion_columns)>> all{};
  auto* next = std::copy(others.begin(), others.end(), all.begin());
  for_each_field(motion_columns, [&next](const auto& column) { *next++ = form_of(column); });
  return all;
}();

inline constexpr std::size_t quantity_count = quantity_forms.size();

static_assert(std::ranges::is_sorted(quantity_forms, {}, &QuantityForm::quantity));

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

/// The inputs that may be ranges, each followed by the quantity of its other end.
inline constexpr std::array ranged_inputs{Quantity::v0, Quantity::p, Quantity::k, Quantity::lambda};

/// If an input is a range, the quantity of the end that does not stand for it.
constexpr std::optional<Quantity> other_end(Quantity input) {
  return contains(ranged_inputs, input) ? std::optional(quantity_forms[index(input) + 1].quantity)
                                        : std::nullopt;
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
