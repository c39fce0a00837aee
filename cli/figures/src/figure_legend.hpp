// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <set>

namespace stillpoint::figures {

/// The names in figures, each with a sample, in lines of a given width. Equal names share one
/// entry.
class FigureLegend {
 public:
  explicit FigureLegend(double width) : width_(width) {}

  /// All names except those placed in the plot.
  void add(const Figure& figure, const std::set<std::string>& named);

  [[nodiscard]] double height() const;
  /// With its upper left corner at (x, y).
  [[nodiscard]] std::string drawn(double x, double y) const;

 private:
  struct Entry {
    std::string name;
    std::string sample;  ///< drawn about (12, -4), 24 wide
    double x;
    int line;
  };

  double width_;
  std::vector<Entry> entries_;
  double next_x_{0};
  int last_line_{0};
};

}  // namespace stillpoint::figures
