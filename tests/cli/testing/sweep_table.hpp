// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

#include <cstdint>

namespace stillpoint::cli_test {

/// The rows of a sweep, as texts by column.
struct SweepTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// Throws std::out_of_range where there is none of that name.
  [[nodiscard]] const std::string& at(std::size_t row, std::string_view column) const;
  [[nodiscard]] double number(std::size_t row, std::string_view column) const;
};

[[nodiscard]] SweepTable read_csv(std::string_view text);

/// The inputs of a row, which stand before its results, as options of a single run; the ends of a
/// range are one value.
[[nodiscard]] Arguments inputs_of(const SweepTable& table, std::size_t row);

/// One field of the records of an .npy file.
struct NpyField {
  std::string name;
  std::string type;  ///< "<f8"
};

/// An .npy file of records, read by its own definition.
struct NpyFile {
  std::vector<NpyField> fields;
  std::int64_t count{0};
  std::size_t header_size{0};
  std::string bytes;  ///< of the records

  [[nodiscard]] std::size_t record_size() const;
  [[nodiscard]] double number(std::int64_t row, std::string_view field) const;
  [[nodiscard]] int byte(std::int64_t row, std::string_view field) const;

 private:
  [[nodiscard]] const char* place(std::int64_t row, std::string_view field) const;
};

/// Asserts what the format demands of the header, byte by byte.
[[nodiscard]] NpyFile read_npy(const std::string& file);

}  // namespace stillpoint::cli_test
