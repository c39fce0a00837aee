// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/suite_task.hpp>

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

/// Throws InputError if there is no record or a wrong one.
void require_valid(const std::vector<SuiteRecord>& records);

/// Of valid records.
[[nodiscard]] std::vector<Excitation> scaled_loads(const std::vector<SuiteRecord>& records);

/// The records of a request as loads, and the figures of a damper under them.
class Suite {
 public:
  /// For a request with its combination. Throws InputError for a wrong record.
  explicit Suite(const RecordDesignRequest& request);

  /// Throws InputError for a wrong damper, but not for one that never rests.
  [[nodiscard]] SuiteFigures figures(const SuiteDamper& damper) const;
  /// The same for many, in their order, computed in parallel; `threads` as in record_batch.
  [[nodiscard]] std::vector<SuiteFigures> figures(std::span<const SuiteDamper> dampers,
                                                  const Threads& threads) const;
  /// For one damper, with each motion.
  [[nodiscard]] std::vector<ForcedResponse> responses(const SuiteDamper& damper) const;

  [[nodiscard]] const std::vector<Excitation>& loads() const { return loads_; }
  [[nodiscard]] Oscillator oscillator(const SuiteDamper& damper) const {
    return {damper.p, damper.f, damper.delta, hold_};
  }
  [[nodiscard]] static Surface surface(const SuiteDamper& damper) {
    return {damper.notch_width(), {}};
  }

 private:
  /// The figures of one record.
  void add(SuiteFigures& all, const SuiteFigures& one) const;
  /// For all records; empty if one of them does not settle.
  void combine(SuiteFigures& all) const;
  /// Under one record, which need not be settled.
  [[nodiscard]] std::vector<SuiteFigures> under(const Excitation& load,
                                                std::span<const SuiteDamper> dampers) const;
  void run(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list) const;
  void run_at_once(std::span<const SuiteDamper> dampers, std::span<SuiteFigures> list,
                   const Threads& threads) const;
  [[nodiscard]] ForcedResponse response(const SuiteDamper& damper, const Excitation& load) const;

  std::vector<Excitation> loads_;
  Combine combine_;
  std::optional<double> hold_;
};

/// What a search minimises within the limits; without a figure the largest part of a limit that is
/// used.
struct SuiteGoal {
  double SuiteFigures::*figure{nullptr};
  SuiteLimits limits;
};

/// The rank of a damper or of its box: the less, the better. Any admissible one is better than any
/// other.
struct SuiteRank {
  double off{0};    ///< 0: admissible; else how far it is from that
  double value{0};  ///< of the objective
  double peak{0};   ///< if the objective is the same, as under a load that the notch holds

  [[nodiscard]] auto operator<=>(const SuiteRank&) const = default;
};
/// The largest part of a limit that is used.
[[nodiscard]] double use(const SuiteFigures& figures, const SuiteLimits& limits);
[[nodiscard]] SuiteRank rank(const SuiteFigures& figures, const SuiteGoal& goal);

}  // namespace stillpoint::design
