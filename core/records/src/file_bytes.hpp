// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace stillpoint::records {

/// What a file is, "is a SAC file: ...", if it has a form that is known but not read; "" for others.
[[nodiscard]] std::string_view unread_form(std::string_view bytes);

/// The bytes with LF at each end of a line that is CR alone or CR CR LF, and a blank for each NUL in a
/// line of words. They are in `own` if anything changes.
[[nodiscard]] std::string_view with_plain_lines(std::string_view bytes, std::string& own);

}  // namespace stillpoint::records
