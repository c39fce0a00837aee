// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string>

namespace stillpoint::cli {

/// From now on only errors go to standard error. For --quiet.
void hush();
[[nodiscard]] bool hushed();

/// On standard error, as it is.
void write_error(const std::string& text);

/// What an error says, and what to do about it where it comes from the system.
[[nodiscard]] std::string words_of(const std::exception& error);

/// An error, on standard error, as one line.
void say(const std::string& text);

/// What is not an error: "note: ..." or "warning: ...". Not after hush, and nothing for an empty
/// text.
void remark(const std::string& text);

}  // namespace stillpoint::cli
