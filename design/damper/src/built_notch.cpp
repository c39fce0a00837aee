// SPDX-License-Identifier: MIT
#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/practice.hpp>

namespace stillpoint::design {

namespace {

bool same_motion(const Response& a, const Response& b) {
  return a.outcome == b.outcome && a.stop_time == b.stop_time &&
         a.stop_position == b.stop_position && a.peak_amplitude == b.peak_amplitude;
}

}  // namespace

BuiltNotch built_notch(const DesignRequest& request, const DesignPoint& point,
                       const NotchShape& shape) {
  const Problem& problem = request.problem;
  const Start start{0, request.pulse ? 0 : problem.v0};
  const Excitation load = request.pulse ? excitation(*request.pulse) : NoExcitation();
  const auto with = [&](const NotchShape& notch) {
    const Oscillator oscillator{problem.p, point.f, point.delta, notch.hold};
    return forced_response(oscillator, start, load, {}, Surface{notch.width, {}});
  };
  BuiltNotch built{shape, {}, with(shape)};
  if (shape.width) {
    built.friction = notch_acceleration(point.f, point.delta, *shape.width);
  }
  built.changes_nothing = same_motion(built.response, with({}));
  return built;
}

}  // namespace stillpoint::design
