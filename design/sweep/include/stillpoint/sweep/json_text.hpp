// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/file_error.hpp>

#include <map>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// The places of keys; a key of an object within the outermost one is "outer.inner", deeper ones
/// are left out.
using KeyPlaces = std::map<std::string, records::FilePlace>;

/// Throws FileError, with line and column, unless the text is a JSON object, which may have
/// comments, in which no key appears twice, nothing is nested deeper than 16 levels and every
/// number fits a double.
KeyPlaces require_json_object(std::string_view text, const records::FilePlace& file);

}  // namespace stillpoint::sweep
