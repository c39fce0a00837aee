// SPDX-License-Identifier: MIT
#include "accuracy.hpp"

#include <fmt/format.h>

#include <optional>
#include <variant>

namespace stillpoint::cli {

namespace {

peers::Scene scene_of(const SimulateInput& input) {
  const SimulationRequest& request = input.request;
  peers::Scene scene{request.oscillator, request.start, request.excitation};
  const std::optional<double> t_end =
      request.t_end ? request.t_end
                    : peers::far_enough(scene.oscillator, scene.start, scene.excitation);
  if (!t_end) {
    throw UsageError("the motion never stops: give it some friction, or an excitation and --t-end");
  }
  scene.t_end = *t_end;
  if (is_forced(request) && scene.t_end > peers::longest(scene)) {
    throw UsageError(fmt::format(
        "t-end = {}: the motion up to there is too long for 50 digits, at most {:.3g} for this one",
        scene.t_end, peers::longest(scene)));
  }
  return scene;
}

std::string reason(const SimulationRequest& request) {
  const auto& [p, f, delta] = request.oscillator;
  if (!is_forced(request)) {
    return f > 0 && delta > 0
               ? "the half-cycle map is exact from peak to peak, one square root each, and has no "
                 "step or tolerance to choose"
               : "one friction alone ends in a closed form, an exact remainder, however many "
                 "half-cycles it takes";
  }
  return std::holds_alternative<Record>(request.excitation)
             ? "between samples the motion is a closed form with constant coefficients, and each "
               "interval is proved to hold no event or searched for it"
             : "between events the motion is a closed form, and the first event is found by a "
               "bound "
               "that cannot step over it";
}

}  // namespace

AccuracyAnswer compare_methods(const SimulateInput& input) {
  return {peers::compare(scene_of(input)), reason(input.request)};
}

}  // namespace stillpoint::cli
