// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/names.hpp>
#include <stillpoint/records/csv.hpp>
#include <stillpoint/sweep/quantity.hpp>
#include <stillpoint/sweep/units.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::sweep {

class LineReader;

enum class ListFormat { csv, jsonl };

[[nodiscard]] std::span<const Named<ListFormat>> enumerators(ListFormat) noexcept;
using stillpoint::name;

/// A list in memory: the names of its columns, and their values.
using ListColumns = std::vector<std::pair<std::string, std::vector<double>>>;

/// The length of a list and its digest.
struct ListExtent {
  std::int64_t entries{0};
  std::uint64_t digest{0};
};

/// The entries of a list, one on each line: CSV with a header that names the columns, or JSON
/// objects that all have the same keys. Blank lines are skipped. Columns are inputs of a sweep.
/// A wrong line throws records::FileError, with its number.
class List {
 public:
  /// Reads the header, or the first object. `path` "-" is standard input. Without a format the list
  /// is JSON lines if its first character other than a blank is "{". With `units` its columns have
  /// the names of physical inputs, and its numbers are in SI units.
  explicit List(const std::string& path, std::optional<ListFormat> format = {},
                const std::optional<SweepUnits>& units = {});
  /// Of what is in memory; "line" in errors is then the number of the entry.
  explicit List(std::shared_ptr<const ListColumns> held,
                const std::optional<SweepUnits>& units = {});
  List(const List&) = delete;
  List& operator=(const List&) = delete;
  ~List();

  [[nodiscard]] const std::vector<Quantity>& columns() const { return columns_; }
  [[nodiscard]] bool has(Quantity column) const;
  [[nodiscard]] ListFormat format() const { return format_; }
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
  void add_column(std::string_view name);
  void read_header(std::string_view line);
  void read_row(std::string_view line, std::vector<double>& values);
  void read_object(std::string_view line, std::vector<double>& values);
  [[noreturn]] void refuse(std::string_view what) const;

  std::string path_;
  std::unique_ptr<LineReader> lines_;  ///< null if it is in memory
  std::optional<SweepUnits> units_;
  std::shared_ptr<const ListColumns> held_{};
  std::int64_t given_{0};  ///< entries of it
  ListFormat format_{ListFormat::csv};
  std::vector<Quantity> columns_;
  records::CsvRow row_;
  std::optional<std::vector<double>> first_;  ///< read with the keys, not yet given
};

/// For all that is left of it.
[[nodiscard]] ListExtent read_to_end(List& list);

}  // namespace stillpoint::sweep
