// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/pulse.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// A kind of excitation: an alternative of Excitation that has a wave, or is a record.
struct ExcitationKind {
  std::string_view name;  ///< in --excitation
  Load load{};            ///< the options that shape it
  double angle{0};        ///< lambda times its duration; 0: it does not end by itself
  /// Made from a harmonic with the options of any wave; null: a record.
  Excitation (*wave)(const Harmonic& given){nullptr};
  /// What --pulse makes of it; null: --pulse does not take it.
  design::Pulse (*pulse)(const Harmonic& given){nullptr};
};

[[nodiscard]] std::span<const ExcitationKind> excitation_kinds();

/// Null if there is none of that name.
[[nodiscard]] const ExcitationKind* find_excitation_kind(std::string_view name);

/// The names of all kinds, or of those that --pulse takes.
[[nodiscard]] std::vector<std::string_view> excitation_names(bool of_pulses = false);

}  // namespace stillpoint::cli
