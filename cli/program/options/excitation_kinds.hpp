// SPDX-License-Identifier: MIT
#pragma once

#include "options/load.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/pulse.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// A kind of excitation. A new one is a row of the table in excitation_kinds.cpp.
struct ExcitationKind {
  std::string_view name;  ///< in --excitation
  Load load;              ///< the options that shape it
  double angle{0};        ///< lambda times its duration; 0: it has no end of its own
  /// By a harmonic that has what any wave takes; null: a record.
  Excitation (*wave)(const Harmonic& given);
  /// What --pulse makes of it; null: it is not a hit.
  design::Pulse (*pulse)(const Harmonic& given);
};

[[nodiscard]] std::span<const ExcitationKind> excitation_kinds();

/// Null where there is none of that name.
[[nodiscard]] const ExcitationKind* find_excitation_kind(std::string_view name);

/// The names of all kinds, and of those that --pulse takes.
[[nodiscard]] std::vector<std::string_view> excitation_names();
[[nodiscard]] std::vector<std::string_view> pulse_names();

}  // namespace stillpoint::cli
