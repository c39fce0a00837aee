// SPDX-License-Identifier: MIT
#include "excitation_input.hpp"

#include "excitation_kinds.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <fmt/format.h>

#include <utility>

namespace stillpoint::cli {

namespace {

/// UsageError where an option of an excitation is set that `kind` does not take; null takes none.
void refuse_others(const Settings& settings, const ExcitationKind* kind) {
  for (const ExcitationKind& other : excitation_kinds()) {
    for (const std::string_view option : other.takes) {
      if (settings.has(option) && (kind == nullptr || !kind->has(option))) {
        throw UsageError(
            kind == nullptr
                ? fmt::format("{} is for an excitation: give --excitation as well", option)
                : fmt::format("{} and excitation {} exclude each other", option, kind->name));
      }
    }
  }
}

/// `what` in messages: "excitation" or "pulse".
Harmonic wave(const Settings& settings, std::string_view what) {
  Harmonic wave;
  wave.k = settings.required("k", fmt::format("give --k, the peak of the {} in g", what));
  wave.lambda = settings.required("lambda", "give --lambda, its angular frequency");
  wave.phase = settings.number("phase").value_or(wave.phase);
  wave.duration = settings.number("duration");
  return wave;
}

ExcitationInput record(const Settings& settings, const records::RecordClock& clock,
                       double gravity) {
  records::RecordOptions options;
  options.step = settings.number("record-step");
  if (const auto units = settings.known("record-units")) {
    options.units = records::parse_record_units(*units);
  }
  options.scale = settings.number("record-scale").value_or(1);
  options.gravity_m_per_s2 = gravity;
  options.clock = clock;
  const auto path = settings.text("record");
  if (!path) {
    throw InputError::missing("record", "give --record FILE");
  }
  records::RecordFile file = records::read_record(*path, options);
  return {std::move(file.record),
          report::RecordOrigin{*path, std::move(file.description), settings.text("record-units"),
                               settings.number("record-step"), settings.number("record-scale")}};
}

}  // namespace

std::optional<std::string> excitation_type(const Settings& settings) {
  auto type = settings.known("excitation");
  return !type && settings.has("record") ? std::optional<std::string>("record") : type;
}

std::optional<ExcitationInput> excitation_input(const Settings& settings,
                                                const records::RecordClock& clock, double gravity) {
  const auto type = excitation_type(settings);
  const ExcitationKind* const kind = type ? find_excitation_kind(*type) : nullptr;
  refuse_others(settings, kind);
  if (kind == nullptr) {
    return std::nullopt;
  }
  ExcitationInput input;
  if (kind->wave != nullptr) {
    input.excitation = kind->wave(wave(settings, "excitation"));
  } else {
    input = record(settings, clock, gravity);
  }
  require_valid(input.excitation);
  return input;
}

std::optional<double> forced_end(const Settings& settings, const Excitation& excitation) {
  const auto t_end = settings.number("t-end");
  if (t_end) {
    require_within("t-end", *t_end, smallest_speed, largest_speed);
  } else if (!duration(excitation)) {
    throw InputError::missing("t-end", "give --t-end, the excitation never ends");
  }
  return t_end;
}

std::optional<design::Pulse> pulse_input(const Settings& settings) {
  const auto type = settings.known("pulse");
  if (type) {
    return find_excitation_kind(*type)->pulse(wave(settings, "pulse"));
  }
  // A scene's excitation is for simulate, and these are its options.
  for (const char* const name : {"k", "lambda"}) {
    if (settings.has(name) && !settings.has("excitation")) {
      throw UsageError(fmt::format("{} is for a pulse: give --pulse as well", name));
    }
  }
  return std::nullopt;
}

}  // namespace stillpoint::cli
