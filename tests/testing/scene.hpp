// SPDX-License-Identifier: MIT
#pragma once

// The inputs of one motion, for any scalar, and how tests print them.

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <array>
#include <ostream>

namespace stillpoint::test {

template <class Real = double>
struct Scene {
  Real x0{0};
  Real v0{0};
  Real p{1};
  Real f{0};
  Real delta{0};

  [[nodiscard]] BasicOscillator<Real> oscillator() const { return {p, f, delta}; }
  [[nodiscard]] BasicStart<Real> start() const { return {x0, v0}; }
};

/// The inputs one by one, for tests that change each in turn.
template <class Real>
constexpr std::array<Real Scene<Real>::*, 5> inputs{
    &Scene<Real>::x0, &Scene<Real>::v0, &Scene<Real>::p, &Scene<Real>::f, &Scene<Real>::delta};

/// The same inputs in another scalar; exact where Wide holds every double.
template <class Wide>
Scene<Wide> widened(const Scene<double>& scene) {
  return {Wide(scene.x0), Wide(scene.v0), Wide(scene.p), Wide(scene.f), Wide(scene.delta)};
}

inline Response response(const Scene<double>& scene, const FreeOptions& options = {}) {
  return free_response(scene.oscillator(), scene.start(), options);
}

/// With 17 digits, so that a failing scene can be pasted into a test.
inline std::ostream& operator<<(std::ostream& out, const Scene<double>& scene) {
  const auto digits = out.precision(17);
  out << "{x0 " << scene.x0 << ", v0 " << scene.v0 << ", p " << scene.p << ", f " << scene.f
      << ", delta " << scene.delta << '}';
  out.precision(digits);
  return out;
}

}  // namespace stillpoint::test
