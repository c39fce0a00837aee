// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

#include <string>
#include <vector>

namespace stillpoint::peers {

/// A scene of the comparison and its true result.
struct ReferenceScene {
  std::string name;    ///< S1, ...
  std::string legend;  ///< in words
  bool free{true};     ///< ends in a rest; otherwise at t_end
  Scene scene;         ///< t_end of a free one is four times its stop time: enough to go wrong
  Result truth;        ///< rounded to doubles; steps 0
};

/// S1, S2, FR (the first-return design), S3, S4, S5, from the tables that the scripts in
/// `reference_folder` (data/reference) made. Throws std::runtime_error where they cannot be read.
[[nodiscard]] std::vector<ReferenceScene> reference_scenes(const std::string& reference_folder);

}  // namespace stillpoint::peers
