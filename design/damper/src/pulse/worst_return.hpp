// SPDX-License-Identifier: MIT
#pragma once

// The worst of a first return over the ranges of k, lambda and p, for every f: docs/theory.md
// section 15. In units of the strongest pulse, k, and of the softest spring, p.

#include "pulse/legs.hpp"
#include "pulse/profile.hpp"

#include <stillpoint/design/pulse.hpp>

#include <memory>
#include <vector>

namespace stillpoint::design {

/// For one pulse and one spring it is their PulseProfile. Over ranges every figure of a motion is
/// the largest of any pulse with any spring, and it returns if all do.
class WorstReturn {
 public:
  /// Also with what a weaker pulse may do worst if k has a range, or if the caller varies it.
  /// Only the f of the window are examined.
  explicit WorstReturn(const PulseProblem& problem, bool k_varies = false,
                       const Interval& window = {0, 1});

  /// Of one f alone, in a fraction of the time.
  [[nodiscard]] static FirstReturn only_at(const PulseProblem& problem, double f);

  [[nodiscard]] FirstReturn at(double f) const;
  /// The same for an f that is no sample.
  [[nodiscard]] FirstReturn found_at(double f) const;
  [[nodiscard]] const std::vector<FirstReturn>& samples() const { return samples_; }
  /// The worst from low to high, according to both ends and the samples between them.
  [[nodiscard]] FirstReturn between(double low, double high) const;
  /// The largest need of the samples from low to high, among which are the local maxima.
  [[nodiscard]] double need_of_samples(double low, double high, Criterion criterion) const;
  /// No need at f is larger: for one pulse and spring, that of the samples on either side of it.
  [[nodiscard]] double most_need(double f, Criterion criterion) const;
  /// One pulse and one spring.
  [[nodiscard]] bool is_single() const { return legs_->is_single() && weakest_ == 1; }
  /// The weakest pulse.
  [[nodiscard]] double weakest() const { return weakest_; }
  /// The pulse and the spring, of this problem's, with the largest peak at f.
  [[nodiscard]] PulseProblem largest_peak(PulseProblem problem, double f) const;

 private:
  void add_samples(const Interval& window);

  double weakest_{1};  ///< k_low / k
  std::shared_ptr<const Legs> legs_;
  PulseProfile strongest_;  ///< the worst of the legs under the strongest pulse
  std::vector<FirstReturn> samples_;
};

/// The motions of one search, which asks for the same f again and again, and for others next to it.
class KnownMotions {
 public:
  explicit KnownMotions(const WorstReturn& profile)
      : profile_(profile), motions_(profile.samples()) {}

  [[nodiscard]] const WorstReturn& profile() const { return profile_; }
  /// Valid until the next one.
  const FirstReturn& at(double f);
  /// The largest need from low to high: of both ends and of the samples between them.
  [[nodiscard]] double need_between(double low, double high, Criterion criterion);
  /// Over f, by the difference to a motion nearby where the worst has no slope of its own.
  [[nodiscard]] double need_slope(double f, Criterion criterion);
  /// All of them from low to high, with both ends.
  [[nodiscard]] std::vector<FirstReturn> between(double low, double high);

 private:
  const WorstReturn& profile_;
  std::vector<FirstReturn> motions_;  ///< by f
};

}  // namespace stillpoint::design
