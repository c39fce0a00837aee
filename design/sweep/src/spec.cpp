// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/sweep/quantity.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <string>

namespace stillpoint::sweep {

namespace {

using enum Quantity;

constexpr std::array forced_inputs{record, record_scale, v0,          p,       x0,       f,
                                   delta,  hold,         notch_width, damping, breakaway};
constexpr std::span<const Quantity> free_inputs = std::span(forced_inputs).subspan(2);
constexpr std::array design_inputs{v0,       v0_low,    p,           p_high,   k,
                                   k_low,    lambda,    lambda_high, beta,     residual,
                                   arrivals, trade_off, damping,     breakaway};

/// Those that a motion of this kind has.
template <class Result>
constexpr auto motion_results = [] {
  constexpr auto has = []<class Member>(const MotionColumn<Member>&) {
    return requires(const Result& result, Member member) {
      result.*member;
    };
  };
  constexpr std::size_t count = std::apply(
      [has](const auto&... column) { return (std::size_t{has(column)} + ...); }, motion_columns);
  std::array<Quantity, count> results{};
  std::size_t i = 0;
  for_each_field(motion_columns, [&](const auto& column) {
    if (has(column)) {
      results[i++] = column.quantity;
    }
  });
  return results;
}();

constexpr std::array design_results{feasible,      f,         delta,
                                    tolerance,     arrival,   peak_amplitude,
                                    stop_position, stop_time, peak_absolute_acceleration};

std::vector<Quantity> all_columns(SweepKind kind) {
  std::vector<Quantity> all;
  all.reserve(inputs(kind).size() + results(kind).size());
  std::ranges::copy(inputs(kind), std::back_inserter(all));
  std::ranges::copy(results(kind), std::back_inserter(all));
  return all;
}

}  // namespace

std::optional<std::int64_t> entries(const SweepSpec& spec) {
  if (spec.list) {
    return spec.listed ? std::optional(spec.listed->entries * dampers_of_each(spec)) : std::nullopt;
  }
  constexpr std::int64_t most = 1'000'000'000'000'000;  // below 2^53: a double counts them exactly
  std::int64_t count = 1;
  for (const SweepAxis& swept : spec.axes) {
    if (swept.axis.size() > most / count) {
      throw InputError(option_name(swept.quantity, spec.units), swept.axis.text(),
                       fmt::format("makes a grid of more than {} entries", most));
    }
    count *= swept.axis.size();
  }
  return count;
}

OwnEntries own_entries(const SweepSpec& spec) {
  if (!spec.part) {
    return {0, entries(spec)};
  }
  const EntryRange range = range_of(*spec.part, entries(spec).value_or(0));
  return {range.first, range.count};
}

namespace {

/// The values of the input; size 0 where no axis has them.
std::int64_t count_in_axes(const SweepSpec& spec, Quantity input) {
  const auto found = std::ranges::find_if(spec.axes, [input](const SweepAxis& swept) {
    return swept.quantity == input ||
           (swept.axis.has_ranges() && other_end(swept.quantity) == input);
  });
  return found == spec.axes.end() ? 0 : found->axis.size();
}

}  // namespace

bool given(const SweepSpec& spec, Quantity input) {
  return (spec.list && spec.list->has(input)) || count_in_axes(spec, input) > 0;
}

std::int64_t dampers_of_each(const SweepSpec& spec) {
  return std::max(std::int64_t{1}, count_in_axes(spec, trade_off));
}

bool varies(const SweepSpec& spec, Quantity input) {
  return (spec.list && spec.list->has(input)) || count_in_axes(spec, input) > 1;
}

double only_value(const SweepSpec& spec, Quantity input) {
  const double value = std::ranges::find(spec.axes, input, &SweepAxis::quantity)->axis[0];
  return spec.units ? spec.units->plain(input, value) : value;
}

bool from_zero(const SweepSpec& spec) {
  const auto x0 = std::ranges::find(spec.axes, Quantity::x0, &SweepAxis::quantity);
  return x0 != spec.axes.end() && x0->axis.size() == 1 && x0->axis[0] == 0;
}

bool plain_motion(const SweepSpec& spec) {
  const auto is_given = [&spec](Quantity input) { return given(spec, input); };
  return spec.zones.empty() &&
         std::ranges::none_of(std::array{notch_width, damping, breakaway}, is_given);
}

void add_default_start(SweepSpec& spec) {
  const bool may_rest = spec.kind == SweepKind::forced || given(spec, x0);
  for (const Quantity start : {v0, x0}) {
    if (spec.kind != SweepKind::design && !given(spec, start) && (start == x0 || may_rest)) {
      spec.axes.push_back({start, Axis({0})});
    }
  }
  std::ranges::sort(spec.axes, {}, &SweepAxis::quantity);
}

std::span<const Quantity> inputs(SweepKind kind) {
  return kind == SweepKind::design   ? std::span<const Quantity>(design_inputs)
         : kind == SweepKind::forced ? std::span<const Quantity>(forced_inputs)
                                     : free_inputs;
}

std::span<const Quantity> results(SweepKind kind) {
  switch (kind) {
    case SweepKind::free:
      return motion_results<Response>;
    case SweepKind::forced:
      return motion_results<ForcedResponse>;
    case SweepKind::design:
      return design_results;
  }
  assert(false && "a SweepKind outside its enumeration");
  return {};
}

std::vector<Quantity> default_columns(const SweepSpec& spec, bool times) {
  std::vector<Quantity> columns = all_columns(spec.kind);
  const std::size_t inputs_end = inputs(spec.kind).size();
  std::size_t i = 0;
  const bool design = spec.kind == SweepKind::design;
  const bool may_rest_off_centre = given(spec, residual);
  const auto left_out = [&](Quantity result) {
    return (result == stop_time && !times) ||
           (result == peak_absolute_acceleration && spec.kind == SweepKind::free &&
            plain_motion(spec)) ||
           (result == arrival && !may_rest_off_centre && !varies(spec, arrivals)) ||
           (result == stop_position && design && !may_rest_off_centre);
  };
  std::erase_if(columns, [&](Quantity column) {
    return i++ < inputs_end ? !varies(spec, column) : left_out(column);
  });
  return columns;
}

std::vector<Quantity> parse_columns(std::string_view text, SweepKind kind,
                                    const std::optional<SweepUnits>& units) {
  const std::vector<Quantity> all = all_columns(kind);
  std::vector<Quantity> columns;
  for (const std::string_view wanted : records::split(text, ',')) {
    const auto found = find_named(all, wanted, units);
    if (!found) {
      std::vector<std::string_view> known(all.size());
      std::ranges::transform(all, known.begin(), [&](Quantity now) { return name(now, units); });
      throw InputError("columns",
                       fmt::format("\"{}\"", records::shortened(wanted, records::longest_word)),
                       fmt::format("must be among {}{}", fmt::join(known, ", "),
                                   records::suggestion(wanted, known)));
    }
    if (contains(columns, *found)) {
      throw InputError("columns", std::string(wanted), "must not be named twice");
    }
    columns.push_back(*found);
  }
  return columns;
}

}  // namespace stillpoint::sweep
