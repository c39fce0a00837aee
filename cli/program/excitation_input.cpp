// SPDX-License-Identifier: MIT
#include "excitation_input.hpp"

#include "record_file.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace stillpoint::cli {

namespace {

constexpr std::array wave_options{"k", "lambda", "phase", "duration"};
constexpr std::array record_options{"record", "record-units", "record-step", "record-scale"};

/// UsageError where one of `names` is set, which `type` does not use.
template <class Names>
void refuse(const Settings& settings, const Names& names, std::string_view type) {
  for (const std::string_view name : names) {
    if (settings.has(name)) {
      throw UsageError(type.empty()
                           ? fmt::format("{} is for an excitation: give --excitation as well", name)
                           : fmt::format("{} and excitation {} exclude each other", name, type));
    }
  }
}

struct Wave {
  double k;
  double lambda;
};

Wave wave(const Settings& settings) {
  return {settings.required("k", "give --k, the peak of the excitation in g"),
          settings.required("lambda", "give --lambda, its angular frequency")};
}

template <class Pulse>
Excitation pulse(const Settings& settings, std::string_view type) {
  refuse(settings, std::array{"phase", "duration"}, type);
  const auto [k, lambda] = wave(settings);
  return Pulse{k, lambda};
}

Excitation harmonic(const Settings& settings) {
  const auto [k, lambda] = wave(settings);
  return Harmonic{k, lambda, settings.number("phase").value_or(0), settings.number("duration")};
}

ExcitationInput record(const Settings& settings, const records::RecordClock& clock,
                       double gravity) {
  refuse(settings, wave_options, "record");
  records::RecordOptions options;
  options.step = settings.number("record-step");
  if (const auto units = settings.text("record-units")) {
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
  for (double& time : file.times) {
    time /= clock.per_tau;
  }
  return {Record{std::move(file.values), file.step / clock.per_tau, std::move(file.times)},
          report::RecordOrigin{*path, file.description, settings.text("record-units"),
                               settings.number("record-step"), settings.number("record-scale")}};
}

}  // namespace

std::optional<ExcitationInput> excitation_input(const Settings& settings,
                                                const records::RecordClock& clock, double gravity) {
  const std::string type =
      settings.text("excitation").value_or(settings.has("record") ? "record" : "");
  if (type.empty() && !settings.has("excitation")) {
    refuse(settings, wave_options, "");
    refuse(settings, record_options, "");
    return std::nullopt;
  }
  std::optional<ExcitationInput> input;
  if (type == "record") {
    input = record(settings, clock, gravity);
  } else {
    refuse(settings, record_options, type);
    Excitation excitation;
    if (type == "harmonic") {
      excitation = harmonic(settings);
    } else if (type == "half-sine") {
      excitation = pulse<HalfSine>(settings, type);
    } else if (type == "full-sine") {
      excitation = pulse<FullSine>(settings, type);
    } else if (type == "rectangle") {
      excitation = pulse<Rectangle>(settings, type);
    } else {
      throw InputError("excitation", type,
                       "must be harmonic, half-sine, full-sine, rectangle or record");
    }
    input = ExcitationInput{excitation, {}};
  }
  require_valid(input->excitation);
  return input;
}

}  // namespace stillpoint::cli
