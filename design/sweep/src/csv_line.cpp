// SPDX-License-Identifier: MIT
#include "csv_line.hpp"

#include <stillpoint/records/text.hpp>

#include <cstddef>

namespace stillpoint::sweep {

namespace {

using records::trimmed;

std::string_view without_quotes(std::string_view text) {
  return text.size() >= 2 && text.front() == '"' && text.back() == '"'
             ? trimmed(text.substr(1, text.size() - 2))
             : text;
}

}  // namespace

bool CsvLine::next(std::string_view& field) {
  if (!more_) {
    return false;
  }
  const bool in_quotes = trimmed(rest_).starts_with('"');
  const std::size_t quote = in_quotes ? rest_.find('"', rest_.find('"') + 1) : 0;
  const std::size_t comma = rest_.find(',', quote);  // none behind npos
  unclosed_ = quote == std::string_view::npos;
  more_ = comma != std::string_view::npos;
  field = without_quotes(trimmed(rest_.substr(0, comma)));
  rest_ = more_ ? rest_.substr(comma + 1) : std::string_view();
  return true;
}

}  // namespace stillpoint::sweep
