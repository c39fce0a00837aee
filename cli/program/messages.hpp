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

/// Puts /dev/null in place of each standard stream that is closed, so that no file gets its number
/// and the messages that go there; if `output_is_lost`, one that cannot be written for standard
/// output. Throws std::system_error without a /dev/null.
void open_closed_streams(bool output_is_lost = false);

/// From now on a write that finds a full disk or nobody who reads is an error, after which nothing
/// is left behind, instead of the end of the program.
void outlive_failed_writes();

/// Ends the program silently, as the write would have done, if nobody read what it wrote.
void end_if_nobody_reads();

}  // namespace stillpoint::cli
