// SPDX-License-Identifier: MIT
#include "list_line.hpp"

#include <cstdint>

namespace stillpoint::sweep {

std::span<const std::string> csv_fields(std::string_view line, LineReader& lines,
                                        records::CsvRow& row) {
  const std::int64_t first = lines.number();
  const auto next = [&](std::string_view& more) { return lines.next(more, {}); };
  if (const std::string_view fault = row.read(line, next); !fault.empty()) {
    lines.refuse(first, fault);
  }
  return row.fields();
}

}  // namespace stillpoint::sweep
