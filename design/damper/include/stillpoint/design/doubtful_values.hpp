// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/load_reach.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

/// A value in SI units, and how it was given.
struct GivenValue {
  double value;
  bool with_unit;
};

/// By names such as velocity, max-displacement, natural-frequency.
using GivenValues = std::map<std::string, GivenValue, std::less<>>;

/// A value that makes no sense with the others, or is of no usual size, most often a number in
/// millimetres, milliseconds or tonnes where metres, seconds or kilograms are meant.
struct Doubt {
  /// What was probably meant: this number, in this unit.
  struct Meant {
    std::string name;
    double value;
    std::string unit;
  };
  std::string name;  ///< of the value; empty if several could be at fault
  std::string text;  ///< names the value and says what is wrong with it
  std::optional<Meant> meant{};
};

/// The doubts about a task, first those about values that do not go together. Names that it does
/// not know are ignored. `load` is that of a task in metres.
[[nodiscard]] std::vector<Doubt> doubtful_values(const GivenValues& given,
                                                 const std::optional<LoadReach>& load = {});

}  // namespace stillpoint::design
