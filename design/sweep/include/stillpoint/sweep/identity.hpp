// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/spec.hpp>

#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// SweepSpec::identity of a spec that is otherwise complete. `inputs` is a JSON object with
/// everything that decides the rows, as given, and `version` is that of the program that computes
/// them.
[[nodiscard]] std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                                      std::string_view version);

}  // namespace stillpoint::sweep
