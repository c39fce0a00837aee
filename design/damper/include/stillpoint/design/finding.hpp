// SPDX-License-Identifier: MIT
#pragma once

// What the reader of an answer must know beyond its numbers: docs/reports.md, Findings.

#include <stillpoint/core/names.hpp>
#include <stillpoint/records/units.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stillpoint::design {

enum class Severity {
  info,
  caution,  ///< to be known before anything is built
  fault,    ///< the answer is not to be used as it is
};

enum class FindingKind {
  acts_late,
  catches_hit,
  catches_weak_hits,
  check_failed,
  close_call,
  delta_unbounded,
  does_not_isolate,
  ends_before_load,
  exact_only,
  exceeds_later,
  fails_if_off,
  felt_in_notch,
  friction_above_weight,
  interrupted,
  jolts,
  least_friction_is_best,
  locks,
  never_moves,
  no_notch_works,
  no_width_found,
  notch_changes_nothing,
  notch_fails,
  notch_gains_little,
  notch_needs_width,
  notch_unused,
  peaks_develop,
  ranges_estimated,
  recentres_weakly,
  records_exceed_limit,
  search_cut_short,
  sensitive,
  too_exact,
};

using stillpoint::name;

/// Dimensionless, as all of an answer, but for what counts or names something.
struct FindingValue {
  std::string_view name;
  std::variant<double, std::int64_t, std::string> value;
  records::Dimension dimension{records::Dimension::none};
};

struct Finding {
  FindingKind kind;
  Severity severity;
  std::vector<FindingValue> values;

  explicit Finding(FindingKind of, std::vector<FindingValue> with = {});
  /// A value that does not exist is left out.
  Finding& add(std::string_view name, const std::optional<double>& value,
               records::Dimension dimension = records::Dimension::none);
  Finding& tell(std::string_view name, std::string_view text);
  Finding& count(std::string_view name, std::size_t number);
};

}  // namespace stillpoint::design
