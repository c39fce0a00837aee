// SPDX-License-Identifier: MIT
#pragma once

// The loads of a record at and between its samples, in the units of forced_run.hpp.

#include "kernel/drives.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/functions.hpp"
#include "kernel/record_intervals.hpp"

#include <stillpoint/core/excitation.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace stillpoint {

template <class Real>
class RecordSamples {
 public:
  RecordSamples(const BasicRecord<Real>& record, const Real& p)
      : record_(record), times_(record, p), inverse_p_(1 / p) {}

  [[nodiscard]] const BasicRecord<Real>& record() const { return record_; }
  [[nodiscard]] const RecordTimes<Real>& times() const { return times_; }
  [[nodiscard]] const Real& inverse_p() const { return inverse_p_; }
  [[nodiscard]] std::size_t size() const { return record_.values.size(); }

  /// w at sample i.
  [[nodiscard]] Real operator[](std::size_t i) const { return record_.values[i] * inverse_p_; }
  [[nodiscard]] Load<Real> load(std::size_t i) const {
    return {(*this)[i], ExactSum<Real>(record_.values[i])};
  }
  /// From sample i to the next.
  [[nodiscard]] LinearDrive<Real> drive_from(std::size_t i) const {
    return {(*this)[i], record_.values[i], (*this)[i + 1], record_.values[i + 1], times_.length(i)};
  }

  static constexpr std::size_t at_once = 8;  ///< samples of a rest looked at together
  /// The largest |w + u| at samples i to i + at_once - 1, in any order.
  [[nodiscard]] Real largest_pull(std::size_t i, const Real& u) const {
    std::array<Real, at_once / 2> most{};
    for (std::size_t k = 0; k < most.size(); ++k) {
      most[k] = std::max(magnitude(Real(u + (*this)[i + k])),
                         magnitude(Real(u + (*this)[i + most.size() + k])));
    }
    return *std::max_element(most.begin(), most.end());
  }

 private:
  const BasicRecord<Real>& record_;
  RecordTimes<Real> times_;
  Real inverse_p_;
};

}  // namespace stillpoint
