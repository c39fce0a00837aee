// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace stillpoint::design {

/// f, Delta, the period, the width of the notch, the load, and the damping.
inline constexpr std::size_t most_axes = 6;
/// Of a space, along its axes: logarithms, or parts of a tolerance from -1 to 1.
using SuitePlace = std::array<double, most_axes>;

/// No part is off by more of itself, of tolerances that grow.
inline constexpr double most_off = 0.95;

enum class SuiteFrictions { constant, point, both };
[[nodiscard]] SuiteFrictions frictions_of(const SuiteDamper& damper);

/// A value of a damper that is searched, or may be off, or both.
class SuiteAxis {
 public:
  enum class Variable { f, delta, period, width, load, damping };

  SuiteAxis(Variable variable, const Interval& range, const Spread& spread)
      : variable_(variable), range_(range), spread_(spread) {}

  [[nodiscard]] double value(const SuiteDamper& damper) const;
  void set(SuiteDamper& damper, double value) const;

  [[nodiscard]] double low() const;  ///< logarithms of what the design may be
  [[nodiscard]] double high() const;
  [[nodiscard]] double down() const;  ///< of the tolerance, both positive
  [[nodiscard]] double up() const;
  [[nodiscard]] bool searched() const { return range_.low < range_.high; }
  [[nodiscard]] bool toleranced() const { return spread_.below + spread_.above > 0; }
  [[nodiscard]] const Spread& spread() const { return spread_; }
  [[nodiscard]] const Interval& range() const { return range_; }
  [[nodiscard]] Variable variable() const { return variable_; }

 private:
  Variable variable_;
  Interval range_;  // of the design itself
  Spread spread_;
};

/// Whether no damper of a box is worse than the worst of its corners: docs/damping.md section 5. So
/// it is of hits at whose first return every damper must stop, with a notch that needs no width.
[[nodiscard]] bool worst_at_corners(const RecordDesignRequest& task);

/// The dampers that a search may choose, each with the box of its tolerance.
class SuiteSpace {
 public:
  /// Of a completed request, with its tolerance times `scale`.
  SuiteSpace(const RecordDesignRequest& task, SuiteFrictions frictions, double scale = 1);

  /// False if the friction is not within the ranges, or no box of that size fits below what can be
  /// manufactured.
  [[nodiscard]] bool possible() const { return possible_; }
  [[nodiscard]] bool corners_suffice() const { return corners_suffice_; }
  [[nodiscard]] const std::vector<SuiteAxis>& axes() const { return axes_; }
  [[nodiscard]] std::size_t size() const { return axes_.size(); }
  [[nodiscard]] std::size_t toleranced() const;
  [[nodiscard]] std::size_t searched() const;

  [[nodiscard]] SuiteDamper at(const SuitePlace& logs) const;
  [[nodiscard]] SuitePlace place(const SuiteDamper& damper) const;
  /// The nearest that a design may be.
  [[nodiscard]] SuiteDamper nearest(const SuiteDamper& damper) const;
  /// A damper of the box of `nominal`.
  [[nodiscard]] SuiteDamper off(const SuiteDamper& nominal, const SuitePlace& unit) const;
  /// Whether a design may be there.
  [[nodiscard]] bool includes(const SuitePlace& logs) const;

 private:
  /// With `scale` times its tolerance, besides what it varies by `always`.
  void add(SuiteAxis::Variable variable, Interval range, const Spread& whole, double scale,
           double most, const Spread& always = {});

  bool possible_{true};
  bool corners_suffice_;
  SuiteDamper fixed_;
  std::vector<SuiteAxis> axes_;
};

}  // namespace stillpoint::design
