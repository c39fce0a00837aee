// SPDX-License-Identifier: MIT
#include "record/suite_samples.hpp"

#include <stillpoint/core/elementary.hpp>

#include <cmath>

namespace stillpoint::design {

namespace {

/// The root of x^(d + 1) = x + 1, whose powers fill a box of d dimensions most evenly (Roberts).
double generalised_golden(std::size_t dimensions) {
  double root = 1.5;
  for (int i = 0; i < 60; ++i) {
    root = elementary::exp(elementary::log(1 + root) / static_cast<double>(dimensions + 1));
  }
  return root;
}

void add_corners(std::vector<SuitePlace>& list, const std::vector<std::size_t>& axes) {
  std::size_t count = 1;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    count *= 3;
  }
  for (std::size_t index = 0; index < count; ++index) {
    SuitePlace place{};
    std::size_t left = index;
    for (const std::size_t axis : axes) {
      place.at(axis) = static_cast<double>(left % 3) - 1;
      left /= 3;
    }
    list.push_back(place);
  }
}

void add_even(std::vector<SuitePlace>& list, std::size_t axis, std::size_t count) {
  for (std::size_t i = 1; i + 1 < count; ++i) {
    SuitePlace place{};
    place.at(axis) = 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1;
    list.push_back(place);
  }
}

void add_spread(std::vector<SuitePlace>& list, const std::vector<std::size_t>& axes,
                std::size_t count) {
  const double golden = generalised_golden(axes.size());
  for (std::size_t k = 1; list.size() < count; ++k) {
    SuitePlace place{};
    double share = 1;
    for (const std::size_t axis : axes) {
      share /= golden;
      place.at(axis) = 2 * std::fmod(0.5 + static_cast<double>(k) * share, 1.0) - 1;
    }
    if (k % 2 == 0) {  // each side of each axis in turn
      const std::size_t side = k / 2 % (2 * axes.size());
      place.at(axes[side / 2]) = side % 2 == 0 ? -1 : 1;
    }
    list.push_back(place);
  }
}

}  // namespace

std::vector<SuitePlace> box_samples(const SuiteSpace& space, std::size_t count) {
  std::vector<std::size_t> axes;
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (space.axes()[i].toleranced()) {
      axes.push_back(i);
    }
  }
  std::vector<SuitePlace> list;
  add_corners(list, axes);
  if (space.corners_suffice()) {
    return list;
  }
  if (axes.size() == 1) {
    add_even(list, axes.front(), count);
  } else if (axes.size() > 1) {
    add_spread(list, axes, count);
  }
  return list;
}

}  // namespace stillpoint::design
