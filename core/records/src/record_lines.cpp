// SPDX-License-Identifier: MIT
#include "record_lines.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::records {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr char end_of_dos_file = '\x1A';

/// Bytes that no text has. A form feed and DOS's end of file may stand in a trailer.
bool is_binary(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20U && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != end_of_dos_file;
}

}  // namespace

RecordLines::RecordLines(const std::string& path, const std::string& text)
    : path_(&path), rest_(text) {
  if (rest_.starts_with(byte_order_mark)) {
    rest_.remove_prefix(byte_order_mark.size());
  }
  if (rest_.ends_with(end_of_dos_file)) {
    rest_.remove_suffix(1);
  }
  if (rest_.empty()) {
    throw FileError({"record", path}, "is empty");
  }
  const auto* const found = std::ranges::find_if(rest_, is_binary);
  if (found != rest_.end()) {
    const auto line = 1 + std::count(rest_.begin(), found, '\n');
    refuse(static_cast<std::size_t>(line),
           fmt::format("is not text: it holds the byte 0x{:02X}", static_cast<unsigned>(*found)));
  }
}

bool RecordLines::next() {
  if (rest_.empty()) {
    return false;
  }
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (line_.ends_with('\r')) {
    line_.remove_suffix(1);
  }
  ++number_;
  return true;
}

void RecordLines::refuse(std::size_t number, std::string_view message) const {
  throw FileError({"record", *path_, number}, message);
}

double RecordLines::parse_number(std::string_view text) const {
  const ScannedNumber scanned = scan_fortran_number(text);
  if (scanned.fault != NumberFault::none) {
    refuse(fmt::format("{} {}", quoted(text), explanation(scanned.fault)));
  }
  return scanned.value;
}

}  // namespace stillpoint::records
