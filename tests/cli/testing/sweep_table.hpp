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

/// What a sweep of these options prints: each row must be what `command` alone reports with
/// `fixed` and the row's inputs, as check(table, row, report) asserts.
template <class Check>
SweepTable check_rows(const Sandbox& sandbox, const char* command, const Arguments& fixed,
                      const Arguments& axes, const Check& check) {
  const ProgramRun swept = sandbox.succeed("sweep" + fixed + axes);
  BOOST_TEST(swept.err.empty(), swept.err);
  SweepTable table = read_csv(swept.out);
  BOOST_TEST(!table.rows.empty());
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const Arguments alone = Arguments{command} + fixed + inputs_of(table, row) + "--json";
    BOOST_TEST_CONTEXT("row " << row) {
      check(table, row, sandbox.run(alone).json());
    }
  }
  return table;
}

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
