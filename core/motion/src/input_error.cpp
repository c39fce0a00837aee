// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace stillpoint {

namespace {

/// The part of a wrong value that a message quotes, without cutting a UTF-8 sequence in two.
std::string shortened(const std::string& value) {
  constexpr std::size_t longest = 80;  // a line of a terminal
  if (value.size() <= longest) {
    return value.empty() ? R"("")" : value;
  }
  std::size_t length = longest;
  while (length > 0 && (static_cast<unsigned char>(value[length]) & 0xC0U) == 0x80U) {
    --length;
  }
  return value.substr(0, length) + "...";
}

}  // namespace

InputError::InputError(std::string field, const std::string& value, const std::string& bound)
    : std::invalid_argument(fmt::format("{} = {}: {}", field, shortened(value), bound)),
      field_(std::move(field)) {}

InputError::InputError(std::string field, double value, const std::string& bound)
    : InputError(std::move(field), fmt::format("{}", value), bound) {}

InputError::InputError(std::string field, const Whole& whole)
    : std::invalid_argument(whole.message), field_(std::move(field)) {}

InputError InputError::missing(const std::string& field, const std::string& hint) {
  return {field, Whole{fmt::format("{} is missing: {}", field, hint)}};
}

InputError InputError::named(const std::string& field) const {
  return {field, Whole{field + std::string(what()).substr(field_.size())}};
}

InputError InputError::in_entry(std::ptrdiff_t index) const {
  return named(fmt::format("{}[{}]", field_, index));
}

TooManyHalfCycles::TooManyHalfCycles(double bound, double limit)
    : std::runtime_error(fmt::format("f and delta are so small that the motion may take {:.3g} "
                                     "half-cycles; at most {:.3g} are allowed (half-cycle-limit)",
                                     bound, limit)),
      bound_(bound) {}

TooManyHalfCycles::TooManyHalfCycles(const std::string& message) : std::runtime_error(message) {}

TooManyHalfCycles TooManyHalfCycles::at_least(double least, double limit) {
  return TooManyHalfCycles(
      fmt::format("friction is so small that the motion takes at least {:.3g} "
                  "half-cycles; at most {:.3g} are allowed (half-cycle-limit)",
                  least, limit));
}

TooManyHalfCycles TooManyHalfCycles::in_trajectory(double limit) {
  return TooManyHalfCycles(fmt::format(
      "the trajectory has more than {:.6g} half-cycles: give an earlier end (t_end)", limit));
}

TooManyHalfCycles TooManyHalfCycles::under_excitation(double limit, double tau) {
  return TooManyHalfCycles(
      fmt::format("the motion has more half-cycles than allowed (half-cycle-limit): {:.15g} by "
                  "tau = {:.6g}",
                  limit, tau));
}

TooManyHalfCycles TooManyHalfCycles::in_entry(std::ptrdiff_t index) const {
  return TooManyHalfCycles(fmt::format("entry {}: {}", index, what()));
}

void require_within(std::string_view field, double value, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) {
    return;
  }
  throw InputError(std::string(field), value,
                   fmt::format("must be a number from {} to {}", low, high));
}

}  // namespace stillpoint
