// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/spec.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// What an entry is made of, in the order of the columns.
[[nodiscard]] std::span<const Quantity> inputs(SweepKind kind);

/// What is computed of an entry, in the order of the columns.
[[nodiscard]] std::span<const Quantity> results(SweepKind kind);

/// The inputs that vary, then the results: stop_time, which takes longer, only with `times`.
[[nodiscard]] std::vector<Quantity> default_columns(const SweepSpec& spec, bool times = false);

/// "f,delta,peak_amplitude". Throws InputError for a name that is not a column of this kind, and
/// for one that occurs twice.
[[nodiscard]] std::vector<Quantity> parse_columns(std::string_view names, SweepKind kind);

}  // namespace stillpoint::sweep
