// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/output.hpp>

#include <string>

namespace stillpoint::cli {

using sweep::Output;

/// The document as text, under the title of the settings; in colour only where standard output is a
/// terminal, NO_COLOR is not set (or empty) and TERM is not "dumb".
[[nodiscard]] std::string shown(const report::Document& document, const Settings& settings);

}  // namespace stillpoint::cli
