// SPDX-License-Identifier: MIT
#include "first_beyond.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <variant>

namespace stillpoint {

namespace {

void require_wave(double k, double lambda) {
  require_within("k", k, -largest_speed, largest_speed);
  require_within("lambda", lambda, smallest_speed, largest_speed);
}

void check(const NoExcitation& /*excitation*/) {}

void check(const Harmonic& excitation) {
  require_wave(excitation.k, excitation.lambda);
  require_within("phase", excitation.phase, -largest_phase, largest_phase);
  const double lasts = excitation.duration.value_or(0);
  const bool within = lasts >= smallest_speed && lasts <= largest_speed;
  if (!(lasts == 0 || within)) {
    throw InputError(
        "duration", lasts,
        fmt::format("must be 0 or a number from {} to {}", smallest_speed, largest_speed));
  }
}

template <class Pulse>
void check(const Pulse& pulse) {
  require_wave(pulse.k, pulse.lambda);
}

void check(const Record& record) {
  if (record.values.empty()) {
    throw InputError("record", "no samples", "must have at least one sample");
  }
  if (const auto i = first_beyond(record.values, largest_speed)) {
    throw InputError(fmt::format("record value {}", *i + 1), record.values[*i],
                     fmt::format("must be a number from {} to {}", -largest_speed, largest_speed));
  }
  if (record.times.empty()) {
    require_within("record step", record.step, smallest_speed, largest_speed);
    return;
  }
  if (record.times.size() != record.values.size()) {
    throw InputError("record", fmt::format("{} times", record.times.size()),
                     fmt::format("must be as many as the values, {}", record.values.size()));
  }
  double before = 0;
  for (std::size_t i = 0; i < record.times.size(); ++i) {
    const double time = record.times[i];
    if (!(time <= largest_speed && (i == 0 ? time >= 0 : time > before))) {
      throw InputError(fmt::format("record time {}", i + 1), time,
                       i == 0 ? std::string("must be a number that is at least 0")
                              : fmt::format("must be greater than the previous time, {}", before));
    }
    before = time;
  }
}

}  // namespace

std::string_view name(const Excitation& excitation) noexcept {
  constexpr std::array<std::string_view, std::variant_size_v<Excitation>> names{
      "none", "harmonic", "half-sine", "full-sine", "rectangle", "record"};
  return names.at(excitation.index());
}

void require_valid(const Excitation& excitation) {
  std::visit([](const auto& kind) { check(kind); }, excitation);
}

}  // namespace stillpoint
