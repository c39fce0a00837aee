// SPDX-License-Identifier: MIT
#include "list_line.hpp"

#include <stillpoint/records/text.hpp>

#include <cstddef>

namespace stillpoint::sweep {

std::vector<std::string_view> csv_fields(std::string_view line, const LineReader& lines) {
  std::vector<std::string_view> fields;
  for (bool more = true; more;) {
    const bool in_quotes = records::trimmed(line).starts_with('"');
    const std::size_t quote = in_quotes ? line.find('"', line.find('"') + 1) : 0;
    const std::size_t comma = line.find(',', quote);  // none behind npos
    if (quote == std::string_view::npos) {
      lines.refuse(lines.number(), "a quote is opened but not closed");
    }
    more = comma != std::string_view::npos;
    fields.push_back(records::unquoted(line.substr(0, comma)));
    line.remove_prefix(more ? comma + 1 : 0);
  }
  return fields;
}

}  // namespace stillpoint::sweep
