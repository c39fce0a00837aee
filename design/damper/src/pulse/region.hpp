// SPDX-License-Identifier: MIT
#pragma once

// The admissible (f, Delta) of a pulse: the f whose motion returns, stays within beta and keeps the
// limits, and for each of them every Delta from its need up to delta_max. docs/theory.md section 8.

#include "pulse/intervals.hpp"
#include "pulse/worst_return.hpp"
#include "region/limit_table.hpp"

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/search.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// In the units of WorstReturn.
class PulseRegion {
 public:
  PulseRegion(const PulseProblem& problem, const Limits& limits)
      : PulseRegion(std::make_shared<WorstReturn>(problem), problem, limits) {}
  PulseRegion(std::shared_ptr<const WorstReturn> profile, const PulseProblem& problem,
              const Limits& limits);

  [[nodiscard]] const std::shared_ptr<const WorstReturn>& profile() const { return profile_; }
  /// The intervals of admissible f, regardless of the tolerance.
  [[nodiscard]] const std::vector<Island>& islands() const { return islands_; }
  [[nodiscard]] FirstReturn at(double f) const { return profile_->at(f); }

  /// The largest need of a box, over what delta_max leaves for it: at most 1 if it fits.
  [[nodiscard]] double use_of_delta(double low, double high, double tolerance,
                                    KnownMotions& known) const;
  [[nodiscard]] double use_per_need(double tolerance) const {
    return (1 + shape_.delta_high * tolerance) / (1 - shape_.delta_low * tolerance) / delta_max_;
  }
  /// Of the logarithm of that, over the tolerance.
  [[nodiscard]] double use_growth(double tolerance) const {
    return shape_.delta_low / (1 - shape_.delta_low * tolerance) +
           shape_.delta_high / (1 + shape_.delta_high * tolerance);
  }
  /// The intervals of an island whose need is within that part of what delta_max leaves for a box
  /// of that tolerance.
  [[nodiscard]] std::vector<Island> parts(const Island& island, double tolerance, double use,
                                          KnownMotions& known) const;
  /// What an interval has beyond a box of that tolerance, as a part of it; negative where none
  /// fits.
  [[nodiscard]] double spare(const Island& part, double tolerance) const {
    return part.high / part.low * (low_of(1, tolerance) / high_of(1, tolerance)) - 1;
  }
  [[nodiscard]] bool feasible() const;
  /// From the least to the largest f of any box of the tolerance asked for, a little more than
  /// that; empty if none fits.
  [[nodiscard]] std::optional<Island> around_boxes() const;

  /// The least f that is examined stands for all below it.
  [[nodiscard]] bool reaches_down_to_0(const Island& island) const;
  /// The tolerance of f, as far as delta_max, or the given Delta where that is finite, allows.
  [[nodiscard]] double widest(const Island& island, double f, double delta,
                              KnownMotions& known) const;
  /// The same without delta_max.
  [[nodiscard]] double widest_by_edges(const Island& island, double f) const;
  /// The point of an island with the Delta that leaves the most tolerance, and with half of its
  /// capacity in reserve where delta_max allows.
  [[nodiscard]] DesignPoint with_best_delta(const Island& island, double f,
                                            KnownMotions& known) const;
  /// The largest tolerance of an admissible point; empty for any other.
  [[nodiscard]] std::optional<double> tolerance_of(double f, double delta) const;

  /// f, and Delta, in units of the request.
  [[nodiscard]] double f_unit() const { return k_; }
  [[nodiscard]] double delta_unit() const { return length_ * k_; }
  [[nodiscard]] double length_unit() const { return length_; }
  [[nodiscard]] DesignPoint in_units(const DesignPoint& found) const {
    return {found.f * f_unit(), found.delta * delta_unit(), found.tolerance};
  }
  [[nodiscard]] double asked() const { return asked_; }
  [[nodiscard]] double delta_max() const { return delta_max_; }
  [[nodiscard]] Criterion criterion() const { return criterion_; }

  /// The sides of a box of f.
  [[nodiscard]] double low_of(double f, double tolerance) const {
    return f * (1 - shape_.f_low * tolerance);
  }
  [[nodiscard]] double high_of(double f, double tolerance) const {
    return f * (1 + shape_.f_high * tolerance);
  }
  /// The f whose boxes of that tolerance lie in the interval: none if low > high.
  [[nodiscard]] Island middles(const Island& part, double tolerance) const {
    return {part.low / low_of(1, tolerance), part.high / high_of(1, tolerance)};
  }
  [[nodiscard]] const BoxShape& shape() const { return shape_; }
  /// The largest tolerance that is searched for.
  [[nodiscard]] double most_tolerance() const;

 private:
  /// Of f_max, of beta, and of the limits of figures.
  using Rooms = std::array<double, 2 + figure_count>;
  [[nodiscard]] Rooms rooms(const FirstReturn& motion) const;
  [[nodiscard]] double room(const FirstReturn& motion) const {
    return std::ranges::min(rooms(motion));
  }
  [[nodiscard]] bool holds(const FirstReturn& motion) const { return room(motion) >= 0; }
  void find_islands();
  void add_overlaps(std::vector<FirstReturn>& points) const;

  std::shared_ptr<const WorstReturn> profile_;
  std::vector<Island> islands_;
  Criterion criterion_;
  double k_;
  double length_;
  double beta_;
  double f_max_;
  double delta_max_;
  std::array<double, figure_count> figures_max_{};
  double asked_;  ///< tolerance
  BoxShape shape_;
};

/// Nothing bounds Delta from above but delta_max, so an interval of f that begins at 0 would have
/// any tolerance below 1, with a Delta that grows beyond all bounds. The search ends here, unless
/// more is asked for.
inline constexpr double widest_tolerance = 0.995;

struct PulseMends {
  std::vector<Mend> list;
  bool cut_short{false};  ///< the search for some of them would have taken too long
};

/// Like mends() of a hit, with k and lambda instead of v0; the profile is that of the problem.
[[nodiscard]] PulseMends mends(const PulseProblem& problem, const Limits& limits,
                               const std::shared_ptr<const WorstReturn>& profile);
/// Like criterion_mend() of a hit.
[[nodiscard]] std::optional<Criterion> criterion_mend(
    const PulseProblem& problem, const Limits& limits,
    const std::shared_ptr<const WorstReturn>& profile);

/// The best point, in the units of the region, and the optimum found without NLopt.
struct PulseOptimum {
  SearchResult found;
  Island island;        ///< in which it lies
  double searched{0};   ///< the objective at the best f that NLopt saw
  double bracketed{0};  ///< the same along f alone
};

/// Empty if the region is not feasible. The better of both is the answer.
[[nodiscard]] std::optional<PulseOptimum> search(const PulseRegion& region,
                                                 const SearchOptions& options);

}  // namespace stillpoint::design
