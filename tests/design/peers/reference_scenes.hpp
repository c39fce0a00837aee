// SPDX-License-Identifier: MIT
#pragma once

#include "testing/test.hpp"

#include <stillpoint/peers/methods.hpp>
#include <stillpoint/peers/reference.hpp>

namespace stillpoint::peers {

inline const std::vector<ReferenceScene>& scenes() {
  static const std::vector<ReferenceScene> all =
      reference_scenes(std::string(STILLPOINT_DATA_DIR) + "/reference");
  return all;
}

inline const ReferenceScene& scene(const std::string& name) {
  const auto found = std::find_if(scenes().begin(), scenes().end(),
                                  [&](const ReferenceScene& one) { return one.name == name; });
  BOOST_REQUIRE(found != scenes().end());
  return *found;
}

inline void counts_are_right(const ReferenceScene& scene, const Result& result) {
  BOOST_TEST(result.passages == scene.truth.passages);
  BOOST_TEST(result.turns == scene.truth.turns);
  BOOST_TEST(result.sticks == scene.truth.sticks);
  BOOST_TEST(result.outcome == scene.truth.outcome);
}

inline Scene with(const Excitation& excitation, const Oscillator& oscillator, const Start& start,
                  double t_end) {
  return {oscillator, start, excitation, t_end};
}

}  // namespace stillpoint::peers
