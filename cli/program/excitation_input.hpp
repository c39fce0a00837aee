// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/records/record_file.hpp>

#include <optional>
#include <string>

namespace stillpoint::cli {

/// What shakes the base, and how a report names it.
struct ExcitationInput {
  Excitation excitation;
  std::string type;                         ///< as in --excitation
  std::optional<std::string> record;        ///< the file
  std::string description;                  ///< what the file says of itself
  std::optional<std::string> record_units;  ///< these three as asked for
  std::optional<double> record_step;
  std::optional<double> record_scale;
};

/// Empty where nothing is asked for. A record's times become tau by its `clock`.
/// Throws UsageError for options that exclude each other, FileError for a wrong file and InputError
/// for a wrong value.
[[nodiscard]] std::optional<ExcitationInput> excitation_input(const Settings& settings,
                                                              const records::RecordClock& clock,
                                                              double gravity);

}  // namespace stillpoint::cli
