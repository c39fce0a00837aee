// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace stillpoint::records {

/// At the beginning of some files; not part of their text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The bytes of a file. Throws FileError if it cannot be read or has more than `largest` bytes;
/// `kind` says what the file is to the program, file_error.hpp.
[[nodiscard]] std::string read_text_file(std::string_view kind, const std::string& path,
                                         std::size_t largest);

/// The same from a file that is open; `source` stands for its path.
[[nodiscard]] std::string read_text_stream(std::string_view kind, std::string_view source,
                                           std::size_t largest, std::FILE* file);

/// A file or folder that the file `by` names: beside it if it is there, else as it is named, from
/// where the program runs. FILE#2 is as good as FILE.
[[nodiscard]] std::string beside(const std::string& by, const std::string& name);

}  // namespace stillpoint::records
