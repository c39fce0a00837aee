// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/constraints.hpp>
#include <stillpoint/design/suite_task.hpp>

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace stillpoint::design {

/// A motion with more is not followed to its rest: at a period of 3 s it would last four hours.
inline constexpr double most_suite_half_cycles = 10'000;

/// Whether a motion that comes to rest does so within these. The kernel checks this while it steps,
/// but not after the record with a single friction, which is a closed form of any length.
[[nodiscard]] constexpr bool rests_in_time(double half_cycles) {
  return half_cycles <= most_suite_half_cycles;
}

/// Codes require the largest of few records and the mean of seven or more.
[[nodiscard]] constexpr Combine default_combine(std::size_t records) {
  return records < 7 ? Combine::max : Combine::mean;
}

/// The load itself. Throws InputError for a wrong one, or if there is no record.
void require_valid(const LoadCase& load_case);

/// The part of the load of a case whose least is `own_weakest`, where `load` is that of a task
/// whose least is `weakest`.
[[nodiscard]] double load_part(double load, double own_weakest, double weakest);

/// The motions of one case, and the figures of a damper in them.
class Suite {
 public:
  /// Of a valid case of the request, with its combination.
  Suite(const LoadCase& load_case, const RecordDesignRequest& request);

  /// Throws InputError for a wrong damper, but not for one that never rests.
  [[nodiscard]] SuiteFigures figures(const SuiteDamper& damper) const;
  /// The same for many, in their order, computed in parallel; `threads` as in record_batch.
  [[nodiscard]] std::vector<SuiteFigures> figures(std::span<const SuiteDamper> dampers,
                                                  const Threads& threads) const;
  /// For one damper, with each motion.
  [[nodiscard]] std::vector<ForcedResponse> responses(const SuiteDamper& damper) const;

  /// The one with the largest of a figure.
  [[nodiscard]] std::size_t worst_motion(const SuiteDamper& damper,
                                         const SuiteFigureKind& kind) const;

  [[nodiscard]] const std::vector<CaseMotion>& motions() const { return motions_; }
  [[nodiscard]] Oscillator oscillator(const SuiteDamper& damper) const {
    return oscillator_of(of_all_, damper);
  }
  [[nodiscard]] static Surface surface(const SuiteDamper& damper) {
    return {damper.notch_width(), {}};
  }

 private:
  /// Of the load that comes with a damper.
  [[nodiscard]] double part(const SuiteDamper& damper) const;
  /// The figures of one motion.
  void add(SuiteFigures& all, const SuiteFigures& one) const;
  /// For all motions; empty if one of them does not settle.
  void combine(SuiteFigures& all) const;
  [[nodiscard]] SuiteFigures under(const CaseMotion& motion, const SuiteDamper& damper) const;
  /// In one motion, which need not be settled.
  [[nodiscard]] std::vector<SuiteFigures> under(const CaseMotion& motion,
                                                std::span<const SuiteDamper> dampers) const;
  void run(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list) const;
  void run_at_once(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list,
                   const Threads& threads) const;
  [[nodiscard]] bool moves_freely(const CaseMotion& motion, const SuiteDamper& damper) const;
  [[nodiscard]] ForcedResponse response(const SuiteDamper& damper, const CaseMotion& motion) const;

  std::vector<CaseMotion> motions_;
  Combine combine_;
  RecordDesignRequest of_all_;  // only what is the same of all dampers
  LoadCase load_case_;          // without its records
  double weakest_;
};

/// What grows with the load, and what a mean is taken of.
inline constexpr std::array figures_of_load{&SuiteFigures::peak, &SuiteFigures::acceleration,
                                            &SuiteFigures::residual, &SuiteFigures::jump};

/// A load s times as large moves a damper s times as far as the load itself moves one with f/s,
/// Delta/s^2 and width/s.
[[nodiscard]] SuiteDamper relative_to(const SuiteDamper& damper, double factor);
[[nodiscard]] SuiteFigures times(SuiteFigures figures, double factor);

/// The worst of several dampers.
[[nodiscard]] TaskFigures worst_of(std::span<const TaskFigures> all);

/// Those of all cases of a request with its combinations.
class Suites {
 public:
  explicit Suites(const RecordDesignRequest& request);

  [[nodiscard]] TaskFigures figures(const SuiteDamper& damper) const;
  [[nodiscard]] std::vector<TaskFigures> figures(std::span<const SuiteDamper> dampers,
                                                 const Threads& threads) const;
  [[nodiscard]] const std::vector<Suite>& cases() const { return cases_; }

 private:
  std::vector<Suite> cases_;
};

/// What a search minimises within the limits; without a figure the largest part of a limit that is
/// used.
struct SuiteGoal {
  double SuiteFigures::*figure{nullptr};
  std::optional<std::size_t> in_case{};  ///< empty: the largest of all
  std::vector<SuiteLimits> limits{};     ///< of each case

  /// Of what settles.
  [[nodiscard]] double value(EachFigures figures) const;
};

/// Whether some case has that limit.
[[nodiscard]] bool limits_any(const RecordDesignRequest& request,
                              std::optional<double> SuiteLimits::*limit);
/// The limits of each case.
[[nodiscard]] std::vector<SuiteLimits> limits_of(const RecordDesignRequest& request);

/// The limits that are given, as conditions on the worst of a box.
[[nodiscard]] std::vector<Constraint> constraints_of(const RecordDesignRequest& task,
                                                     const TaskFigures& worst);

/// Of what is not known, or never rests.
inline constexpr SuiteFigures unsettled{.settled = false};

/// The sum over all cases; 1e9 if a motion never rests. Nothing is known against no figures.
[[nodiscard]] double excess(EachFigures figures, const std::vector<SuiteLimits>& limits);
/// Whether it is 0: the damper rests and meets the limits.
[[nodiscard]] bool admissible(EachFigures figures, const std::vector<SuiteLimits>& limits);

/// The rank of a damper or of its box: the less, the better. Any admissible one is better than any
/// other.
struct SuiteRank {
  double off{0};    ///< 0: admissible; else how far it is from that
  double value{0};  ///< of the objective
  double peak{0};   ///< if the objective is the same, as under a load that the notch holds

  [[nodiscard]] auto operator<=>(const SuiteRank&) const = default;
};
/// The largest part of a limit that is used.
[[nodiscard]] double use(EachFigures figures, const std::vector<SuiteLimits>& limits);
[[nodiscard]] SuiteRank rank(EachFigures figures, const SuiteGoal& goal);

}  // namespace stillpoint::design
