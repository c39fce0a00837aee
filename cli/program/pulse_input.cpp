// SPDX-License-Identifier: MIT
#include "pulse_input.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <string>

namespace stillpoint::cli {

std::optional<std::string> pulse_type(const Settings& settings) {
  auto type = settings.text("pulse");
  if (type && *type != "half-sine" && *type != "rectangle") {
    throw InputError("pulse", *type, "must be half-sine or rectangle");
  }
  return type;
}

std::optional<design::Pulse> pulse_input(const Settings& settings) {
  const auto type = pulse_type(settings);
  if (!type) {
    // A scene's excitation is for simulate, and these are its options.
    for (const char* const name : {"k", "lambda"}) {
      if (settings.has(name) && !settings.has("excitation")) {
        throw UsageError(fmt::format("{} is for a pulse: give --pulse as well", name));
      }
    }
    return std::nullopt;
  }
  const double k = settings.required("k", "give --k, the peak of the pulse in g");
  const double lambda = settings.required("lambda", "give --lambda, its angular frequency");
  if (*type == "half-sine") {
    return HalfSine{k, lambda};
  }
  return Rectangle{k, lambda};
}

}  // namespace stillpoint::cli
