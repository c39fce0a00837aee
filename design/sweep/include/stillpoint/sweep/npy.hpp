// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// One field of a NumPy record that is an 8-byte float of this machine: "('f', '<f8'), ".
[[nodiscard]] std::string npy_number(std::string_view name);

/// The header of a NumPy file, version 1.0, of records with these fields, one after the other. Its
/// length does not depend on `rows`.
[[nodiscard]] std::string npy_header(const std::string& fields, std::int64_t rows);

/// Such a header for another number of rows, of the same length. Any other text stays as it is.
[[nodiscard]] std::string with_rows(std::string header, std::int64_t rows);

}  // namespace stillpoint::sweep
