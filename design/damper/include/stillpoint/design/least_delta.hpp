// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/pulse.hpp>

#include <functional>
#include <optional>

namespace stillpoint::design {

/// Delta >= this stops the mass at its first return under friction f: half the square of the
/// arrival speed, by the published criterion f^2/(2 p^2) more; with ranges the largest. Empty if
/// the mass does not return.
[[nodiscard]] std::optional<double> least_delta(const PulseProblem& problem, double f);
/// The same as a function of f, for many f.
[[nodiscard]] std::function<std::optional<double>(double)> least_delta(const PulseProblem& problem);

}  // namespace stillpoint::design
