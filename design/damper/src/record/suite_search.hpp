// SPDX-License-Identifier: MIT
#pragma once

// The best damper of a space with its box: docs/records-design.md section 2.

#include "record/known_dampers.hpp"
#include "record/suite_boxes.hpp"
#include "record/suite_samples.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace stillpoint::design {

/// Dampers of a box that verify a design, and a box that is told of, but not given.
inline constexpr std::size_t verifying_samples = 4000;
inline constexpr std::size_t brief_samples = 1000;

/// A damper whose whole box was tried.
struct VerifiedBox {
  BoxedDamper box;
  std::vector<WorstDampers> of{};  ///< of each case
  std::int64_t samples{0};
};

/// Of a box whose place is not exact yet: one that is hardly off may lie beside one that is not.
[[nodiscard]] double merit(const BoxedDamper& box);

/// Looks for one goal in one space.
class SuiteSearch {
 public:
  /// A brief one looks near the likeliest alone, and does not verify a design.
  SuiteSearch(const Suites& suite, const RecordDesignRequest& task, const SuiteSpace& space,
              SuiteGoal goal, SuiteWatch& watch, bool brief = false);

  /// The likeliest of a map of the whole space to be better than `bar`, best first and polished;
  /// the first is the nearest to the limits where none is within them.
  [[nodiscard]] std::vector<BoxedDamper> likeliest(const BoxMap& map, const SuiteGrid& grid,
                                                   double bar);
  /// Moves a box of samples by ever smaller steps; with `enough` until it meets the limits, and
  /// only as long as it may become better than `bar`.
  [[nodiscard]] BoxedDamper polished(const BoxedDamper& from, double step, bool enough = false,
                                     double bar = HUGE_VAL);
  /// The best of the candidates of which no sample breaks a limit, if it is better than `bar`;
  /// other samples and smaller limits may mend one that fails.
  [[nodiscard]] std::optional<VerifiedBox> verified(const std::vector<BoxedDamper>& candidates,
                                                    double bar = HUGE_VAL);
  /// As it is; the whole box even where a limit is broken.
  [[nodiscard]] VerifiedBox tried(const SuiteDamper& damper, bool whole = false);
  /// By the samples, until one breaks a limit.
  [[nodiscard]] BoxedDamper unbroken(const SuiteDamper& damper);
  /// What another search of dampers with the same variables knows.
  void learn(const KnownDampers& known) { known_.add(known); }
  [[nodiscard]] const KnownDampers& known() const { return known_; }
  /// As it is built: with few digits, and not beside a decision.
  [[nodiscard]] BoxedDamper ready(const BoxedDamper& found) { return clear(rounded(found, 12)); }
  /// With few digits, if that costs next to nothing; itself if `most` of them cost more.
  [[nodiscard]] BoxedDamper rounded(const BoxedDamper& found, int most);

 private:
  [[nodiscard]] BoxedDamper boxed(const SuiteDamper& damper, const TaskFigures& worst) const {
    return {damper, worst, rank(worst, goal_)};
  }
  /// By what is known of it.
  [[nodiscard]] BoxedDamper known(const SuiteDamper& damper) const {
    return boxed(damper, known_.worst(damper));
  }
  [[nodiscard]] std::vector<TaskFigures> figures(const std::vector<SuiteDamper>& dampers);
  [[nodiscard]] BoxedDamper sampled(const SuiteDamper& damper);
  [[nodiscard]] std::vector<BoxedDamper> shortlist(const std::vector<BoxedDamper>& found,
                                                   const SuiteGrid& grid, double bar);
  /// By a few samples, which do for a choice.
  [[nodiscard]] std::vector<BoxedDamper> roughly(const std::vector<BoxedDamper>& found);
  [[nodiscard]] std::vector<SuiteDamper> around(const SuiteDamper& damper, double step,
                                                bool far) const;
  [[nodiscard]] BoxedDamper best_of(const std::vector<SuiteDamper>& dampers,
                                    const BoxedDamper& bar);
  [[nodiscard]] double first_step() const;
  /// The likeliest of a map with that grid on ever finer ones about them, best first.
  [[nodiscard]] std::vector<BoxedDamper> all_refined(const std::vector<BoxedDamper>& found,
                                                     const SuiteGrid& grid, double bar);
  /// At most that many times half the step, which it leaves in `grid`.
  [[nodiscard]] BoxedDamper refined(BoxedDamper candidate, SuiteGrid& grid, int levels);
  void learn(std::span<const SuitePlace> places, const std::vector<TaskFigures>& all);
  [[nodiscard]] BoxedDamper clear(const BoxedDamper& found) const;

  const Suites& suite_;
  const RecordDesignRequest& task_;
  const SuiteSpace& space_;
  SuiteGoal goal_;
  SuiteWatch& watch_;
  bool brief_;
  KnownDampers known_;
  std::vector<SuitePlace> samples_;  ///< those that were worst last come first
};

}  // namespace stillpoint::design
