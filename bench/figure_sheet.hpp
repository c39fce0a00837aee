// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <string>
#include <vector>

namespace stillpoint::figures {

/// Several figures that share one legend.
struct FigureSheet {
  std::string id;
  std::string title;
  std::string description;
  std::vector<Figure> figures;
  int columns{2};
};

/// A file that follows the reader's choice of light or dark.
[[nodiscard]] std::string svg(const FigureSheet& sheet);

}  // namespace stillpoint::figures
