// SPDX-License-Identifier: MIT
#pragma once

// What standard output can show.

#include <cstddef>

namespace stillpoint::report {

/// How wide text may be: $COLUMNS, else the width of the terminal on standard output, else 80; at
/// least 50.
[[nodiscard]] std::size_t terminal_width();

/// Only where standard output is a terminal, NO_COLOR is not set (or empty) and TERM is not "dumb".
[[nodiscard]] bool terminal_has_colours();

}  // namespace stillpoint::report
