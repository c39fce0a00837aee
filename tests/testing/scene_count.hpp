// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace stillpoint::test {

/// How many random forced scenes to try: a thousand, fewer under sanitizers, or the
/// value of STILLPOINT_FORCED_SCENES in the environment.
inline int forced_scene_count() {
  const char* asked = std::getenv("STILLPOINT_FORCED_SCENES");
#ifdef __SANITIZE_ADDRESS__
  const int usual = 100;
#else
  const int usual = 1000;
#endif
  return asked != nullptr ? std::atoi(asked) : usual;
}

}  // namespace stillpoint::test
