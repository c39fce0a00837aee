// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::cli {

/// Puts /dev/null in place of each standard stream that is closed, so that no file gets its number
/// and the messages that go there. Throws std::system_error without a /dev/null.
void open_closed_streams();

/// From now on a write that finds a full disk or nobody who reads is an error, after which nothing
/// is left behind, instead of the end of the program.
void outlive_failed_writes();

/// Ends the program silently, as the write would have done, if nobody read what it wrote.
void end_if_nobody_reads();

}  // namespace stillpoint::cli
