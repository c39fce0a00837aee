// SPDX-License-Identifier: MIT
#include <stillpoint/report/document.hpp>

#include <fmt/format.h>

#include <utility>

namespace stillpoint::report {

void Section::row(std::string label, std::string text, Tone tone) {
  parts.emplace_back(Row{std::move(label), std::move(text), tone});
}

void Section::line(std::string text, Tone tone) {
  parts.emplace_back(Line{std::move(text), tone});
}

Section& Document::section(std::string heading) {
  return sections.emplace_back(Section{std::move(heading), {}});
}

std::string spelled_out(std::string_view text) {
  constexpr unsigned char first_printable = 0x20;
  constexpr unsigned char del = 0x7f;
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    result +=
        code < first_printable || code == del ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return result;
}

}  // namespace stillpoint::report
