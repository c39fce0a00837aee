// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/record_design.hpp>

#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::bench {

/// All suites have p = 1 at a period of 2.8 s, so that lengths are in g/omega^2, 1.947 m.
inline constexpr double omega = 2 * std::numbers::pi / 2.8;
inline constexpr double metre = omega * omega / 9.80665;

struct NamedSuite {
  std::string part;  ///< the objective, "residual", or "exact residual"
  std::string name;
  design::RecordDesignRequest request;
  std::vector<double> tolerances;
};

/// "holds 0.1 g"
[[nodiscard]] std::string notch_words(const design::RecordDesignRequest& request);

/// Suites of the two synthetic records in `folder`, of pulses, and of both scaled, with two
/// variables and with three, for each objective; and of `more` records, a folder or a list, if
/// there are any.
[[nodiscard]] std::vector<NamedSuite> suites(const std::string& folder,
                                             const std::optional<std::string>& more);

}  // namespace stillpoint::bench
