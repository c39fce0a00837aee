// SPDX-License-Identifier: MIT
#pragma once

// What standard output can show.

#include <cstddef>

namespace stillpoint::report {

/// How wide text may be: $COLUMNS, else the width of the terminal on standard output, else 80; at
/// least 50.
[[nodiscard]] std::size_t terminal_width();

/// Whether a terminal, if there is one, understands escape sequences: TERM is set, and not "dumb".
[[nodiscard]] bool terminal_has_escapes();

/// Only where standard output is such a terminal, and NO_COLOR is not set (or empty).
[[nodiscard]] bool terminal_has_colours();

}  // namespace stillpoint::report
