// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/spec.hpp>

#include <string>
#include <string_view>

// Everything that a result depends on, as a JSON object: parts are joined, and what was interrupted
// is resumed, only if it is the same. `inputs` is a JSON object with everything that was given and
// decides the numbers; `version` is that of the program that computes them.

namespace stillpoint::sweep {

/// SweepSpec::identity of a spec that is otherwise complete.
[[nodiscard]] std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                                      std::string_view version);

}  // namespace stillpoint::sweep
