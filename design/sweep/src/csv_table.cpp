// SPDX-License-Identifier: MIT
#include "csv_table.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cstdint>

namespace stillpoint::sweep {

namespace {

/// "1 value", "2 values"
std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

CsvTable::CsvTable(const std::string& path, const std::string& kind, std::string_view needed)
    : lines_(path, kind) {
  if (!read({})) {
    lines_.refuse({}, fmt::format("is empty: it must have a header{}", needed));
  }
  for (const std::string& name : row_.fields()) {
    names_.emplace_back(records::trimmed(name));
  }
}

bool CsvTable::next(const std::stop_token& stop) {
  if (!read(stop)) {
    return false;
  }
  if (row_.fields().size() != names_.size()) {
    refuse(fmt::format("has {}, but the header names {}", counted(row_.fields().size(), "value"),
                       counted(names_.size(), "column")));
  }
  return true;
}

/// A quoted field may go on in further lines.
bool CsvTable::read(const std::stop_token& stop) {
  std::string_view line;
  if (!lines_.next(line, stop)) {
    return false;
  }
  const std::int64_t first = lines_.number();
  const auto go_on = [this](std::string_view& more) { return lines_.next(more, {}); };
  if (const std::string_view fault = row_.read(line, go_on); !fault.empty()) {
    lines_.refuse(first, fault);
  }
  return true;
}

void CsvTable::refuse(std::string_view what) const {
  lines_.refuse(lines_.number(), what);
}

}  // namespace stillpoint::sweep
