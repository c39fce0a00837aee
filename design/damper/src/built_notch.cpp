// SPDX-License-Identifier: MIT
#include <stillpoint/design/built_notch.hpp>

namespace stillpoint::design {

BuiltNotch built_notch(const DesignRequest& request, const DesignPoint& point, double width) {
  const Problem& problem = request.problem;
  const Oscillator oscillator{problem.p, point.f, point.delta};
  const Start start{0, request.pulse ? 0 : problem.v0};
  const Excitation load = request.pulse ? excitation(*request.pulse) : NoExcitation();
  Surface surface;
  surface.notch_width = width;
  return {width, point.f + point.delta / width,
          forced_response(oscillator, start, load, {}, surface)};
}

}  // namespace stillpoint::design
