// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/spec.hpp>

#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// SweepSpec::identity of a spec that is complete but for that. `inputs` is a JSON object of what
/// decides the rows, as it was given, and `version` that of the program that computes them.
[[nodiscard]] std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                                      std::string_view version);

}  // namespace stillpoint::sweep
