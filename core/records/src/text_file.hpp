// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace stillpoint::cli {

/// The bytes of a file. Throws UsageError where it cannot be read or has more than `largest` bytes;
/// the message begins with `kind` and the path, e.g. "record motion.AT2: cannot be read: ...".
[[nodiscard]] std::string read_text_file(std::string_view kind, const std::string& path,
                                         std::size_t largest);

/// The same of what is open already; `source` stands for the path.
[[nodiscard]] std::string read_text_stream(std::string_view kind, std::string_view source,
                                           std::size_t largest, std::FILE* file);

}  // namespace stillpoint::cli
