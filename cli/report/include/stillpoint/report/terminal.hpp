// SPDX-License-Identifier: MIT
#pragma once

// What standard output can show, and how far a command is.

#include <cstddef>
#include <string>

namespace stillpoint::report {

/// How wide text may be: $COLUMNS, else the width of the terminal on standard output, else 80; at
/// least 50.
[[nodiscard]] std::size_t terminal_width();

/// Whether a terminal, if there is one, understands escape sequences: TERM is set, and not "dumb".
[[nodiscard]] bool terminal_has_escapes();

/// Only where standard output is such a terminal, and NO_COLOR is not set (or empty).
[[nodiscard]] bool terminal_has_colours();

/// "tau 3 of 10, 30 %"; `end` is 0 if that is not known.
[[nodiscard]] std::string progress_in_tau(double tau, double end);

/// ", 0:50 left"
[[nodiscard]] std::string time_left(double seconds);

}  // namespace stillpoint::report
