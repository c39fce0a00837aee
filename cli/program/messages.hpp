// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace stillpoint::cli {

/// From here on standard error gets nothing but errors. For --quiet.
void hush();
[[nodiscard]] bool hushed();

/// An error, on standard error, as one line.
void say(const std::string& text);

/// What is not an error: "note: ..." or "warning: ...". Not after hush, and nothing of no text.
void remark(const std::string& text);

}  // namespace stillpoint::cli
