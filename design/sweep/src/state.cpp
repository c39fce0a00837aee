// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/state.hpp>

#include "block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace stillpoint::sweep {

void SweepBlock::cut(Eigen::Index count) {
  for (Eigen::ArrayXd& column : columns) {
    column.conservativeResize(std::min(count, column.size()));
  }
  const auto kept = static_cast<std::size_t>(count);
  lines.resize(std::min(kept, lines.size()));
  digests.resize(std::min(kept, digests.size()));
  size = count;
}

std::uint64_t digest(const Excitation& excitation) {
  Digest digest;
  if (const auto* const record = std::get_if<Record>(&excitation)) {
    digest.add(record->step);
    std::ranges::for_each(record->values, [&](double value) { digest.add(value); });
    std::ranges::for_each(record->times, [&](double time) { digest.add(time); });
  }
  return digest.value();
}

std::uint64_t digest(const std::vector<design::Part>& parts) {
  Digest digest;
  for (const design::Part& part : parts) {
    digest.add(part.f);
    digest.add(part.delta);
  }
  return digest.value();
}

void SweepState::add(const SweepBlock& block) {
  rows += block.size;
  digest = block.digest();
  if (block[Quantity::outcome].size() == block.size) {
    for (Eigen::Index i = 0; i < block.size; ++i) {
      const auto outcome = static_cast<std::size_t>(block[Quantity::outcome][i]);
      ++outcomes[outcome];
      locked_outcomes[outcome] += block.locks(i) ? 1 : 0;
    }
  }
  if (block[Quantity::feasible].size() == block.size) {
    feasible += static_cast<std::int64_t>(block[Quantity::feasible].sum());
  }
}

void SweepState::add(const SweepState& part) {
  rows += part.rows;
  feasible += part.feasible;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    outcomes[i] += part.outcomes[i];
    locked_outcomes[i] += part.locked_outcomes[i];
  }
  sweep::add(reduction, part.reduction);
}

std::string summary(const SweepState& state, bool of_designs) {
  if (of_designs) {
    return state.feasible == state.rows && state.rows > 1
               ? fmt::format("All {} entries have an admissible design.", state.rows)
               : fmt::format("{} of {} entries have an admissible design.", state.feasible,
                             state.rows);
  }
  const std::int64_t locked = state.locked();
  const auto count = [&state](std::size_t outcome) {
    return state.outcomes[outcome] - state.locked_outcomes[outcome];
  };
  const std::int64_t in_notch = count(sweep_outcome(Outcome::stopped_in_notch));
  const std::int64_t centred = count(sweep_outcome(Outcome::stopped_at_zero)) + in_notch;
  const std::string_view centre = in_notch == 0         ? "at x = 0"
                                  : in_notch == centred ? "in the notch"
                                                        : "at x = 0 or in the notch";
  const std::int64_t off_centre = count(sweep_outcome(Outcome::stopped_in_dead_zone));
  const std::int64_t rows = state.rows - locked;
  if (locked == 0 && rows > 1 && std::max(centred, off_centre) == rows) {
    return fmt::format("All {} motions stop {}.", rows, centred == rows ? centre : "off centre");
  }
  std::string text =
      locked > 0 ? fmt::format(
                       "Locked: in {} motions the notch holds the mass until the end of the "
                       "load.",
                       rows > 0 || locked == 1 ? fmt::format("{} of {}", locked, state.rows)
                                               : fmt::format("all {}", locked))
                 : fmt::format("{} of {} motions stop {}", centred, rows, centre);
  if (locked > 0 && rows == 0) {
    return text;
  }
  if (locked > 0) {
    text += fmt::format(" Of the rest, {} stop{} {}", centred, centred == 1 ? "s" : "", centre);
  }
  const auto add = [&text](std::int64_t how_many, std::string_view one, std::string_view several) {
    if (how_many > 0) {
      text += fmt::format(", {} {}", how_many, how_many == 1 ? one : several);
    }
  };
  add(off_centre, "off centre", "off centre");
  add(count(sweep_outcome(Outcome::caught_at_start)), "never starts", "never start");
  add(count(sweep_outcome(Outcome::never_stops)), "never stops", "never stop");
  add(count(sweep_outcome(Outcome::running)), "is not known to have stopped",
      "are not known to have stopped");
  add(count(too_many_half_cycles), "may have too many half-cycles",
      "may have too many half-cycles");
  return text + ".";
}

}  // namespace stillpoint::sweep
