// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/spec.hpp>

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace stillpoint::sweep {

std::string_view name(SweepKind kind) noexcept {
  switch (kind) {
    case SweepKind::free:
      return "free";
    case SweepKind::forced:
      return "forced";
    case SweepKind::design:
      return "design";
  }
  assert(false && "a SweepKind outside its enumeration");
  return "";
}

std::string_view name(RowFormat format) noexcept {
  return format == RowFormat::csv ? "csv" : "npy";
}

std::optional<std::int64_t> entries(const SweepSpec& spec) {
  if (spec.list) {
    return std::nullopt;
  }
  constexpr std::int64_t most = 1'000'000'000'000'000;  // below 2^53: a double counts them exactly
  std::int64_t count = 1;
  for (const SweepAxis& swept : spec.axes) {
    if (swept.axis.size() > most / count) {
      throw InputError(std::string(name(swept.quantity)), swept.axis.text(),
                       fmt::format("makes a grid of more than {} entries", most));
    }
    count *= swept.axis.size();
  }
  return count;
}

bool varies(const SweepSpec& spec, Quantity input) {
  return (spec.list && spec.list->has(input)) ||
         std::ranges::any_of(spec.axes, [input](const SweepAxis& swept) {
           return swept.quantity == input && swept.axis.size() > 1;
         });
}

bool from_zero(const SweepSpec& spec) {
  const auto x0 = std::ranges::find(spec.axes, Quantity::x0, &SweepAxis::quantity);
  return x0 != spec.axes.end() && x0->axis.size() == 1 && x0->axis[0] == 0;
}

}  // namespace stillpoint::sweep
