// SPDX-License-Identifier: MIT
#pragma once

// The inputs of a motion in another scalar; exact where Wide holds every double.

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <optional>
#include <variant>

namespace stillpoint {

template <class Wide>
BasicOscillator<Wide> widened(const Oscillator& oscillator) {
  return {Wide(oscillator.p),     Wide(oscillator.f),
          Wide(oscillator.delta), std::optional<Wide>(oscillator.hold),
          Wide(oscillator.zeta),  Wide(oscillator.breakaway)};
}

template <class Wide>
BasicStart<Wide> widened(const Start& start) {
  return {Wide(start.x0), Wide(start.v0)};
}

template <class Wide>
BasicSurface<Wide> widened(const Surface& surface) {
  BasicSurface<Wide> wide{std::optional<Wide>(surface.notch_width), {}};
  for (const FrictionZone& zone : surface.zones) {
    wide.zones.push_back({Wide(zone.to), Wide(zone.f)});
  }
  return wide;
}

template <class Wide>
struct Widen {
  BasicExcitation<Wide> operator()(const NoExcitation& none) const { return none; }
  BasicExcitation<Wide> operator()(const Harmonic& e) const {
    return BasicHarmonic<Wide>{Wide(e.k), Wide(e.lambda), Wide(e.phase),
                               std::optional<Wide>(e.duration)};
  }
  template <template <class> class Pulse>
  BasicExcitation<Wide> operator()(const Pulse<double>& e) const {
    return Pulse<Wide>{Wide(e.k), Wide(e.lambda)};
  }
  BasicExcitation<Wide> operator()(const Record& e) const {
    return BasicRecord<Wide>{
        {e.values.begin(), e.values.end()}, Wide(e.step), {e.times.begin(), e.times.end()}};
  }
};

template <class Wide>
BasicExcitation<Wide> widened(const Excitation& excitation) {
  return std::visit(Widen<Wide>(), excitation);
}

}  // namespace stillpoint
