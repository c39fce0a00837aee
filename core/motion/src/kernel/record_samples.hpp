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
#include <cmath>
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

/// The largest |W| from `from` until `until`, docs/forced.md (F30): at a sample, or at an end,
/// which may lie between two.
template <class Real>
Real largest_load(const BasicRecord<Real>& record, const Real& p, const ExactSum<Real>& from,
                  const ExactSum<Real>& until) {
  using std::max;
  const RecordTimes<Real> times(record, p);
  const ExactSum<Real> begin = from.minus(times.at(0)) < 0 ? times.at(0) : from;
  if (record.values.size() < 2 || !(until.minus(begin) > 0)) {
    return Real(0);
  }
  const auto load = [&](const ExactSum<Real>& when) {
    const std::size_t i = times.latest(when);
    if (i + 1 == record.values.size()) {
      return record.values[i];
    }
    const Real part = when.minus(times.at(i)) / times.length(i);
    return Real(record.values[i] + (record.values[i + 1] - record.values[i]) * part);
  };
  const Real largest = max(magnitude(load(begin)), magnitude(load(until)));
  std::array<Real, 8> most{};  // several, which do not wait for each other
  most.fill(largest);
  const std::size_t end = times.latest(until) + 1;
  std::size_t i = times.latest(begin) + 1;
  for (; i + most.size() <= end; i += most.size()) {
    for (std::size_t k = 0; k < most.size(); ++k) {
      most[k] = max(most[k], magnitude(record.values[i + k]));
    }
  }
  for (; i < end; ++i) {
    most[0] = max(most[0], magnitude(record.values[i]));
  }
  return *std::max_element(most.begin(), most.end());
}

}  // namespace stillpoint
