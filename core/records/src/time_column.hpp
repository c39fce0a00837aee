// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace stillpoint::records {

/// The times of a file. They become the step h = t_1 if they are 0, h, 2 h, ... except for the
/// rounding of doubles:
///
///     t_0 = 0  and  |t_i - i h| <= 2^-51 t_i  for every i.
///
/// A decimal time is off its double by 2^-53, relative; so is h, and so is the product. The bound
/// leaves room for these three and no more: the step moves no time further than two units in its
/// last place. Times that were rounded to fewer digits (0, 0.0333, 0.0667) stay as they are.
///
/// Times that begin below 0 are counted from the first, and h is their mean interval:
/// |t_i - t_0 - i h| <= 2^-51 (|t_i| + |t_0|).
class TimeColumn {
 public:
  /// Refuses, at the line of `reader`, a time that is not after the one before, or that no motion
  /// can follow.
  void add(double time, const RecordReader& reader);

  /// The step or the times, in tau.
  void move_to(Record& record);

  /// "; the times are counted from the first, -2"; "" if they begin at 0 or later.
  [[nodiscard]] std::string note() const;

 private:
  [[nodiscard]] double start() const { return std::min(first_, 0.0); }
  [[nodiscard]] bool is_uniform(double step) const;

  std::vector<double> times_;  ///< as they are in the file
  double first_{0};
  double per_tau_{1};
};

}  // namespace stillpoint::records
