// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/file_error.hpp>

#include <string_view>

namespace stillpoint::sweep {

/// Throws FileError, with line and column, unless the text is a JSON object, which may have
/// comments, in which no key stands twice, nothing is nested deeper than 16 levels and every number
/// is a double.
void require_json_object(std::string_view text, const records::FilePlace& file);

}  // namespace stillpoint::sweep
