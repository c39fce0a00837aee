// SPDX-License-Identifier: MIT
#pragma once

// The intervals between the samples of a record, in the units of forced_run.hpp: when they begin,
// how long they are, and the coefficients of (F16) and (F21) of docs/forced.md, which depend on the
// length alone.

#include "kernel/damped_terms.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/positivity.hpp"

#include <stillpoint/core/excitation.hpp>

#include <cstddef>
#include <limits>

namespace stillpoint {

/// (F16) or docs/damping.md (D3) over a whole interval of length h, with dw = rate h in place of
/// the rate.
template <class Real>
struct IntervalTerms {
  Real h{0};
  Real sine{0};
  Real versine{0};
  Real lag{0};     ///< (h - sin h) / h
  Real bend{0};    ///< (1 - cos h) / h
  Real pull{0};    ///< sin h / h
  Real fall{0};    ///< -h / 8
  Real cosine{0};  ///< cos(h/2), or less: between samples |a| is at most that at them over this
  // With damping:
  const DampedSwing<Real>* swing{nullptr};  ///< of the law, which lives longer
  Real reach{0};                            ///< the sine and 2 zeta times the versine
  Real drag{0};                             ///< the versine and 2 zeta times the sine
  Real twice_zeta{0};
  Real swell{1};  ///< (D8)
  Real lift{0};
  Real least_v{0};  ///< what v must exceed at both ends anyway; no v does if h is too long

  IntervalTerms() = default;
  explicit IntervalTerms(const Real& length) : IntervalTerms(length, LinearTerms<Real>(length)) {}

  [[nodiscard]] static IntervalTerms damped(const Real& length, const DampedSwing<Real>& swing) {
    IntervalTerms terms(length, swing.after(length));
    const Real& zeta = swing.zeta();
    terms.swing = &swing;
    const Real growth = exponential_high(Real(zeta * length));
    const Real eighth = length * length / 8;
    terms.reach = terms.sine + 2 * zeta * terms.versine;
    terms.drag = terms.versine + 2 * zeta * terms.sine;
    terms.twice_zeta = 2 * zeta;
    terms.fall *= growth;
    terms.cosine /= growth;
    terms.swell = growth / (1 - eighth);
    terms.lift = eighth + zeta * length / 2;
    return terms;
  }

 private:
  template <class Terms>
  IntervalTerms(const Real& length, const Terms& terms)
      : h(length),
        sine(terms.sine),
        versine(terms.versine),
        lag(terms.lag / length),
        bend(terms.versine / length),
        pull(terms.sine / length),
        fall(-length / 8),
        cosine(1 - length * length / 8),
        least_v(length < 1 ? Real(0) : std::numeric_limits<Real>::max()) {}
};

template <class Real>
class RecordTimes {
 public:
  RecordTimes(const BasicRecord<Real>& record, const Real& p)
      : record_(record), p_(p), even_(p * record.step) {}

  /// p times the time of a sample.
  [[nodiscard]] ExactSum<Real> at(std::size_t i) const {
    return record_.times.empty() ? ExactSum<Real>::product(even_, Real(i))
                                 : ExactSum<Real>::product(p_, record_.times[i]);
  }

  /// The last sample that is not after p tau = `when`, or the first.
  [[nodiscard]] std::size_t latest(const ExactSum<Real>& when) const {
    std::size_t low = 0;
    std::size_t high = record_.values.size() - 1;
    if (even()) {
      const auto about = static_cast<double>(Real(when.value() / even_));
      std::size_t i = !(about < static_cast<double>(high)) ? high
                      : about > 0                          ? static_cast<std::size_t>(about)
                                                           : 0;
      for (; i > 0 && when.minus(at(i)) < 0; --i) {
      }
      for (; i < high && !(when.minus(at(i + 1)) < 0); ++i) {
      }
      return i;
    }
    while (low < high) {
      const std::size_t middle = high - (high - low) / 2;
      if (when.minus(at(middle)) < 0) {
        high = middle - 1;
      } else {
        low = middle;
      }
    }
    return low;
  }

  /// Whether all intervals have one length.
  [[nodiscard]] bool even() const { return record_.times.empty(); }

  /// p times the length of the interval after it.
  [[nodiscard]] Real length(std::size_t i) const {
    return record_.times.empty() ? even_ : Real(p_ * (record_.times[i + 1] - record_.times[i]));
  }

 private:
  const BasicRecord<Real>& record_;
  Real p_;
  Real even_;
};

}  // namespace stillpoint
