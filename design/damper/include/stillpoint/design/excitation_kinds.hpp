// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/pulse.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// A kind of excitation: an alternative of Excitation that has a wave, or is a record.
struct ExcitationKind {
  std::string_view name;
  double angle{0};  ///< lambda times its duration; 0: it does not end by itself
  /// Made from a harmonic with the numbers of any wave; null: a record.
  Excitation (*wave)(const Harmonic& given){nullptr};
  /// The same as the hit of a design; null: it is none.
  Pulse (*pulse)(const Harmonic& given){nullptr};
};

[[nodiscard]] std::span<const ExcitationKind> excitation_kinds();

/// Null if there is none of that name.
[[nodiscard]] const ExcitationKind* find_excitation_kind(std::string_view name);

/// The names of all kinds, or of those that can be the hit of a design.
[[nodiscard]] std::vector<std::string_view> excitation_names(bool of_pulses = false);

}  // namespace stillpoint::design
