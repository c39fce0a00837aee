// SPDX-License-Identifier: MIT
#pragma once

#include "checkpoint.hpp"
#include "descriptor.hpp"

#include <string>

namespace stillpoint::sweep {

/// The files of a sweep that is not complete: FILE.part has its rows, and FILE.part.json, the
/// checkpoint, says how many bytes of that are whole rows.
struct OpenPart {
  std::string target;     ///< FILE, behind its links
  Descriptor descriptor;  ///< of FILE.part, locked, at its end; not open if there is none
  Checkpoint saved;       ///< what FILE.part.json says

  [[nodiscard]] std::string part() const { return target + ".part"; }
  [[nodiscard]] std::string checkpoint() const { return part() + ".json"; }
};

/// Both make the files ready for the rows that are still to come, and throw as open_rows does.
/// `task` is the identity of the sweep.
[[nodiscard]] OpenPart begin_part(const std::string& path, std::string task);
/// Begins if there is nothing to resume.
[[nodiscard]] OpenPart resume_part(const std::string& path, std::string task);

}  // namespace stillpoint::sweep
