// SPDX-License-Identifier: MIT
#include "list_line.hpp"

#include <stillpoint/records/text.hpp>

#include <cstddef>

namespace stillpoint::sweep {

bool CsvLine::next(std::string_view& field) {
  if (!more_) {
    return false;
  }
  const bool in_quotes = records::trimmed(rest_).starts_with('"');
  const std::size_t quote = in_quotes ? rest_.find('"', rest_.find('"') + 1) : 0;
  const std::size_t comma = rest_.find(',', quote);  // none behind npos
  if (quote == std::string_view::npos) {
    lines_.refuse(lines_.number(), "a quote is opened but not closed");
  }
  more_ = comma != std::string_view::npos;
  field = records::unquoted(rest_.substr(0, comma));
  rest_ = more_ ? rest_.substr(comma + 1) : std::string_view();
  return true;
}

}  // namespace stillpoint::sweep
