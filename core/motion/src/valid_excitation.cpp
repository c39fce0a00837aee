// SPDX-License-Identifier: MIT
#include "kernel/excitation_law.hpp"
#include "require.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stillpoint {

namespace {

/// The first value that is larger in magnitude or not a number; limit >= 0. It first tests whether
/// there is any, since a record is checked before each run: magnitudes are ordered like their bits,
/// with NaN last, and differences of integers compile to vector instructions.
std::optional<std::size_t> first_beyond(const std::vector<double>& values, double limit) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const auto limit_bits = std::bit_cast<std::uint64_t>(limit);
  std::uint64_t differences = 0;
  for (const double value : values) {
    differences |= limit_bits - (std::bit_cast<std::uint64_t>(value) & ~sign);
  }
  if ((differences & sign) == 0) {
    return std::nullopt;
  }
  std::size_t i = 0;
  while (std::abs(values[i]) <= limit) {
    ++i;
  }
  return i;
}

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
  require(lasts == 0 || within, "duration", lasts, "must be 0 or a number from {} to {}",
          smallest_speed, largest_speed);
}

template <class Law>
void check(const Law& law) {
  require_wave(law.k, law.lambda);
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

/// Over a period of the slower motion, the phase of the faster one is then rounded by up to 1e-3.
constexpr double largest_ratio = 1e12;

/// The load relative to p: force and, for a wave, frequency.
void require_scaled_wave(double k, double lambda, double p) {
  const double load = std::abs(k) / p;
  require(k == 0 || (load >= smallest_speed && load <= largest_speed), "k", k,
          "k / p must be 0 or have a magnitude from {} to {} (p = {})", smallest_speed,
          largest_speed, p);
  const double ratio = lambda / p;
  require(ratio >= 1 / largest_ratio && ratio <= largest_ratio, "lambda", lambda,
          "lambda / p must be from {:g} to {:g} (p = {})", 1 / largest_ratio, largest_ratio, p);
}

void check_scaled(const NoExcitation& /*excitation*/, double /*p*/, double /*t_end*/) {}

template <class Wave>
void check_scaled(const Wave& wave, double p, double t_end) {
  require_scaled_wave(wave.k, wave.lambda, p);
  require(wave.lambda * std::fmin(t_end, duration_of<double>(wave)) <= largest_phase, "t_end",
          t_end, "lambda t_end must be at most {} (lambda = {})", largest_phase, wave.lambda);
}

void check_scaled(const Record& record, double p, double /*t_end*/) {
  const auto i = p < 1 ? first_beyond(record.values, largest_speed * p) : std::nullopt;
  if (i) {  // otherwise the values themselves are small enough
    throw InputError(fmt::format("record value {}", *i + 1), record.values[*i],
                     fmt::format("value / p must be at most {} (p = {})", largest_speed, p));
  }
  for (std::size_t j = 1; j < record.times.size(); ++j) {
    if (!(p * (record.times[j] - record.times[j - 1]) >= smallest_speed)) {
      throw InputError(
          fmt::format("record time {}", j + 1), record.times[j],
          fmt::format("p times the step from the previous time must be at least {} (p = {})",
                      smallest_speed, p));
    }
  }
  require(!record.times.empty() || p * record.step >= smallest_speed, "record step", record.step,
          "its product with p must be at least {} (p = {})", smallest_speed, p);
}

}  // namespace

void require_valid(const Excitation& excitation) {
  std::visit([](const auto& kind) { check(kind); }, excitation);
}

void require_valid(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
                   const std::optional<double>& t_end) {
  require_valid(oscillator, start);
  require_valid(excitation);
  const std::optional<double> lasts = duration(excitation);
  if (!t_end && !lasts) {
    throw InputError("t_end", "nothing", "must be given: the excitation never ends");
  }
  if (t_end) {
    require_within("t_end", *t_end, smallest_speed, largest_speed);
  }
  const double end = t_end ? *t_end : *lasts;
  std::visit([&](const auto& kind) { check_scaled(kind, oscillator.p, end); }, excitation);
  require(oscillator.p * end <= largest_phase, t_end ? "t_end" : "duration", end,
          "its product with p must be at most {} (p = {})", largest_phase, oscillator.p);
}

}  // namespace stillpoint
