// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::records {

/// A row of CSV as RFC 4180 has it: a field in double quotes may contain commas, line ends and
/// quotes, which are doubled. Blanks around a field are not part of it. A quote elsewhere stands
/// for itself.
class CsvRow {
 public:
  /// Gives the next line, without its end; false if there is none.
  using NextLine = std::function<bool(std::string_view& line)>;

  /// Reads the row that begins with `line`, and the lines in which a quoted field goes on. Returns
  /// what is wrong; "" if nothing is. The fields keep their memory for the next row.
  [[nodiscard]] std::string_view read(std::string_view line, const NextLine& next);
  [[nodiscard]] std::span<const std::string> fields() const { return {fields_.data(), count_}; }

 private:
  [[nodiscard]] std::string_view add(std::string_view line);
  std::string& begin_field(std::string_view& line);

  std::vector<std::string> fields_;  ///< the first `count_` are those of the row
  std::size_t count_{0};
  bool is_open_{false};  ///< a quote
};

}  // namespace stillpoint::records
