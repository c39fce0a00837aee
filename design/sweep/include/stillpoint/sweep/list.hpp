// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/quantity.hpp>
#include <stillpoint/sweep/units.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::sweep {

class CsvFile;

/// A list in memory: the names of its columns, and their values.
using ListColumns = std::vector<std::pair<std::string, std::vector<double>>>;

/// The length of a list and its digest.
struct ListExtent {
  std::int64_t entries{0};
  std::uint64_t digest{0};
};

/// The entries of a list, one on each line: CSV with a header that names the columns. Blank lines
/// are skipped. Columns are inputs of a sweep. A wrong line throws records::FileError, with its
/// number.
class List {
 public:
  /// Reads the header. `path` "-" is standard input. With `units` its columns have the names of
  /// physical inputs, and its numbers are in SI units.
  explicit List(const std::string& path, const std::optional<SweepUnits>& units = {});
  /// Of what is in memory; "line" in errors is then the number of the entry.
  explicit List(std::shared_ptr<const ListColumns> held,
                const std::optional<SweepUnits>& units = {});
  List(const List&) = delete;
  List& operator=(const List&) = delete;
  ~List();

  [[nodiscard]] const std::vector<Quantity>& columns() const { return columns_; }
  [[nodiscard]] bool has(Quantity column) const;
  /// "standard input", the path, or "arrays".
  [[nodiscard]] const std::string& source() const;

  /// Of the whole list, which is read again. Throws FileError if it is not a file.
  [[nodiscard]] ListExtent whole() const;

  /// The values of the next entry, one for each column; false at the end and after a stop.
  [[nodiscard]] bool next(std::vector<double>& values, const std::stop_token& stop = {});
  /// The line of the last entry read, from 1.
  [[nodiscard]] std::int64_t line() const;

  /// Throws FileError about line `line`.
  [[noreturn]] void refuse(std::int64_t line, std::string_view what) const;

 private:
  void add_column(std::string_view field);
  [[nodiscard]] double value(std::size_t column) const;
  [[noreturn]] void refuse(std::string_view what) const;

  std::string path_;
  std::unique_ptr<CsvFile> file_;  ///< null if it is in memory
  std::optional<SweepUnits> units_;
  std::shared_ptr<const ListColumns> held_{};
  std::int64_t given_{0};  ///< entries of held_
  std::vector<Quantity> columns_;
};

/// For all that is left of it.
[[nodiscard]] ListExtent read_to_end(List& list);

}  // namespace stillpoint::sweep
