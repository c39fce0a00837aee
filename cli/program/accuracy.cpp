// SPDX-License-Identifier: MIT
#include "accuracy.hpp"

#include <stillpoint/peers/comparison.hpp>

#include <fmt/format.h>

#include <optional>

namespace stillpoint::cli {

peers::Scene comparison_scene(const SimulationRequest& request) {
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

}  // namespace stillpoint::cli
