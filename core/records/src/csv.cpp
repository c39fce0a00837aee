// SPDX-License-Identifier: MIT
#include <stillpoint/records/csv.hpp>

#include <stillpoint/records/text.hpp>

#include <algorithm>

namespace stillpoint::records {

namespace {

std::string_view without_first_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

/// Moves what is within the quotes from `line` to `field`. Whether the quotes are closed.
bool take_quoted(std::string_view& line, std::string& field) {
  for (;;) {
    const std::size_t quote = line.find('"');
    field += line.substr(0, quote);
    if (quote == std::string_view::npos) {
      field += '\n';
      line = {};
      return false;
    }
    line.remove_prefix(quote + 1);
    if (!line.starts_with('"')) {
      return true;
    }
    field += '"';
    line.remove_prefix(1);
  }
}

}  // namespace

std::string_view CsvRow::read(std::string_view line, const NextLine& next) {
  constexpr std::size_t longest = std::size_t{1} << 16U;  // bytes; a stray quote ends no file
  count_ = 0;
  is_open_ = false;
  std::string_view fault = add(line);
  for (std::size_t size = line.size(); fault.empty() && is_open_; size += line.size()) {
    const bool more = size <= longest && next(line);
    fault = more ? add(line) : "a quote is opened but not closed";
  }
  return fault;
}

std::string& CsvRow::begin_field(std::string_view& line) {
  if (count_ == fields_.size()) {
    fields_.emplace_back();
  }
  std::string& field = fields_[count_];
  ++count_;
  field.clear();
  line = without_first_blanks(line);
  is_open_ = line.starts_with('"');
  line.remove_prefix(is_open_ ? 1 : 0);
  return field;
}

std::string_view CsvRow::add(std::string_view line) {
  for (;;) {
    std::string& field = is_open_ ? fields_[count_ - 1] : begin_field(line);
    if (is_open_) {
      is_open_ = !take_quoted(line, field);
      line = without_first_blanks(line);
    } else {
      const std::string_view bare = line.substr(0, line.find(','));
      field = trimmed(bare);
      line.remove_prefix(bare.size());
    }
    if (line.empty()) {
      return {};
    }
    if (!line.starts_with(',')) {
      return "text follows a closing quote; a quote within quotes must be doubled";
    }
    line.remove_prefix(1);
  }
}

}  // namespace stillpoint::records
