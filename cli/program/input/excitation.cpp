// SPDX-License-Identifier: MIT
#include "input/excitation.hpp"

#include "input/record.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/excitation_kinds.hpp>
#include <stillpoint/design/wave_clock.hpp>

namespace stillpoint::cli {

namespace {

/// The seconds of one tau; empty without physical input.
std::optional<double> time_unit(const Physical& physical) {
  return physical ? std::optional(physical->scales.time_s) : std::nullopt;
}

Load load_of(const design::ExcitationKind& kind) {
  return kind.wave == nullptr ? Load::record : kind.angle == 0 ? Load::harmonic : Load::pulse;
}

/// Throws UsageError if an option of an excitation is set that `kind` does not take; null takes
/// none.
void refuse_others(const Settings& settings, const design::ExcitationKind* kind) {
  const Option* const wrong = settings.first([&](const Option& option) {
    return option.traits.load != Load::none && (kind == nullptr || !option.shapes(load_of(*kind)));
  });
  if (wrong != nullptr) {
    throw UsageError(
        kind != nullptr
            ? fmt::format("{} and excitation {} cannot be combined: {}", wrong->name, kind->name,
                          wrong->traits.instead.words.empty() ? "give one of them"
                                                              : wrong->traits.instead.words)
        : wrong->traits.load == Load::record
            ? fmt::format("{} needs a record: give --record as well", wrong->name)
            : fmt::format("{} needs an excitation: give --excitation as well", wrong->name));
  }
}

design::WaveClock wave_clock(const Option& clock) {
  return clock.traits.dimension == Dimension::time ? design::WaveClock::duration
                                                   : design::WaveClock::frequency;
}

/// The angular frequency, however it was given. tau is the time over `time_s`.
double lambda(const Settings& settings, const design::ExcitationKind& kind,
              const std::optional<double>& time_s) {
  if (const Option* const clock = with_unit(settings, "lambda")) {
    const double given = *settings.number(clock->name);
    records::require_physical(clock->name, clock->traits.dimension, given);
    return design::lambda_of(wave_clock(*clock), given, kind.angle, *time_s);
  }
  return settings.required(
      "lambda", time_s ? kind.angle != 0 ? "give --pulse-duration in s, --excitation-frequency in "
                                           "Hz, or --lambda, the dimensionless angular frequency"
                                         : "give --excitation-frequency in Hz, or --lambda, the "
                                           "dimensionless angular frequency"
                       : "give --lambda, the angular frequency");
}

/// `what` in messages: "excitation" or "pulse".
Harmonic wave(const Settings& settings, std::string_view what, const design::ExcitationKind& kind,
              const std::optional<double>& time_s) {
  Harmonic wave;
  wave.k = settings.required("k", fmt::format("give --k, the peak of the {} in g", what));
  wave.lambda = lambda(settings, kind, time_s);
  wave.phase = settings.number("phase").value_or(wave.phase);
  wave.duration = in_either(settings, "duration", time_s.value_or(1), 0);
  return wave;
}

/// The largest length of a pulse, as the option that gives it has it: its bound in lambda would
/// tell the user nothing.
void require_followed(const Settings& settings, const design::ExcitationKind& kind,
                      const Physical& physical) {
  const Option* const clock = with_unit(settings, "lambda");
  if (clock == nullptr) {
    return;
  }
  const design::Scales& scales = physical->scales;
  const double bound = design::value_of(wave_clock(*clock), scales.p / design::slowest_pulse,
                                        kind.angle, scales.time_s);
  const bool lasts = wave_clock(*clock) == design::WaveClock::duration;
  const double given = *settings.number(clock->name);
  if (lasts ? given > bound : given < bound) {
    const std::string_view unit = records::units_of(clock->traits.dimension).front().name;
    throw InputError(std::string(clock->name), fmt::format("{} {}", given, unit),
                     fmt::format("must be at {} {:.4g} {}: a longer pulse cannot be computed",
                                 lasts ? "most" : "least", bound, unit));
  }
}

ExcitationInput record(const Settings& settings, const records::RecordClock& clock,
                       std::optional<double> p) {
  records::RecordOptions options = record_options(settings, clock);
  const records::RecordScale scale = record_scale(settings, clock, p);
  options.scale = scale.factor;
  const auto path = settings.text("record");
  if (!path) {
    throw InputError::missing("record", "give --record FILE");
  }
  records::RecordFile file = records::read_record(*path, options);
  const double factor = records::factor_to_target(scale, file.record, *path, clock);
  for (double& value : file.record.values) {
    value *= factor;
  }
  const std::string units(name(file.units));
  return {std::move(file.record),
          report::RecordOrigin{*path, std::move(file.description), settings.text("record-units"),
                               settings.number("record-step"), settings.number("record-scale"),
                               scale.target.peak, scale.target.spectrum,
                               settings.number("record-spectrum-period"), options.scale * factor,
                               units, file.assumed_g}};
}

}  // namespace

std::optional<std::string> excitation_type(const Settings& settings) {
  auto type = settings.known("excitation");
  return !type && settings.has("record") ? std::optional<std::string>("record") : type;
}

void require_options_of_record(const Settings& settings) {
  if (const auto type = excitation_type(settings); type && *type != "record") {
    throw UsageError(
        fmt::format("records-list and excitation {} cannot be combined: give one of them", *type));
  }
  refuse_others(settings, design::find_excitation_kind("record"));
}

std::optional<ExcitationInput> excitation_input(const Settings& settings, const Physical& physical,
                                                std::optional<double> p) {
  const auto type = excitation_type(settings);
  const design::ExcitationKind* const kind = type ? design::find_excitation_kind(*type) : nullptr;
  refuse_others(settings, kind);
  if (kind == nullptr) {
    return std::nullopt;
  }
  ExcitationInput input;
  if (kind->wave != nullptr) {
    input.excitation = kind->wave(wave(settings, "excitation", *kind, time_unit(physical)));
  } else {
    // Scaling a record to its spectrum at the period of the motion requires a single motion.
    input = record(settings, record_clock(physical, p.value_or(1)), p);
  }
  require_valid(input.excitation);
  return input;
}

std::optional<double> end_of_run(const Settings& settings, const Physical& physical) {
  const auto t_end =
      in_either(settings, "t-end", time_unit(physical).value_or(1), smallest_physical);
  if (t_end) {
    require_within("t-end", *t_end, smallest_speed, largest_speed);
  }
  return t_end;
}

std::optional<double> forced_end(const Settings& settings, const Excitation& excitation,
                                 const Physical& physical) {
  const auto t_end = end_of_run(settings, physical);
  if (!t_end && !duration(excitation)) {
    throw InputError::missing(physical ? "end-time" : "t-end",
                              physical ? "give --end-time in s, because the excitation never ends"
                                       : "give --t-end, because the excitation never ends");
  }
  return t_end;
}

void require_no_pulse_options(const Settings& settings) {
  const Option* const wrong =
      settings.first([](const Option& option) { return option.shapes(Load::pulse); });
  // A scene's excitation is for simulate, and these are its options.
  if (wrong != nullptr && !settings.has("excitation")) {
    throw UsageError(fmt::format("{} needs a pulse: give --pulse as well", wrong->name));
  }
}

std::optional<design::Pulse> pulse_input(const Settings& settings, const Physical& physical) {
  if (const auto type = settings.known("pulse")) {
    const design::ExcitationKind& kind = *design::find_excitation_kind(*type);
    require_followed(settings, kind, physical);
    return kind.pulse(wave(settings, "pulse", kind, time_unit(physical)));
  }
  require_no_pulse_options(settings);
  return std::nullopt;
}

design::PulseRanges pulse_ranges(const Settings& settings,
                                 const std::optional<design::Pulse>& pulse) {
  design::PulseRanges ranges;
  if (!pulse) {
    return ranges;
  }
  if (const auto k = settings.range("k")) {
    ranges.k_low = k->low;
  }
  const Option* const clock = settings.given(Rivals::frequency);
  if (const auto range = clock != nullptr ? settings.range(clock->name) : std::nullopt) {
    records::require_physical(clock->name, clock->traits.dimension, range->low);
    ranges.lambda_high = design::angular_frequency(*pulse) * (range->high / range->low);
  }
  return ranges;
}

}  // namespace stillpoint::cli
