// SPDX-License-Identifier: MIT
#pragma once

#include "figure_words.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stillpoint::figures {

struct NamesInPlace {
  std::vector<PlacedName> words;
  std::set<std::string> named;  ///< these are not in the legend, nor is what is too thin to see
  std::optional<Box> inset;
};

/// Notes, and the names of areas, bands, map areas and labelled curves that find room.
[[nodiscard]] NamesInPlace names_in_place(const Figure& figure, const Plane& plane);

}  // namespace stillpoint::figures
