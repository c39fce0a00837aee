// SPDX-License-Identifier: MIT
#include <stillpoint/report/document.hpp>

#include <fmt/color.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace stillpoint::report {

namespace {

constexpr std::size_t label_width = 18;
constexpr std::size_t page_width = 96;

fmt::text_style look_of(Tone tone) {
  switch (tone) {
    case Tone::plain:
      break;
    case Tone::heading:
      return fmt::emphasis::bold;
    case Tone::good:
      return fmt::fg(fmt::terminal_color::green);
    case Tone::bad:
      return fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red);
    case Tone::faint:
      return fmt::emphasis::faint;
  }
  return {};
}

/// Renders the parts of a document.
class Text {
 public:
  explicit Text(bool coloured) : coloured_(coloured) {}

  [[nodiscard]] std::string styled(Tone tone, std::string_view text) const {
    return coloured_ && tone != Tone::plain ? fmt::format("{}", fmt::styled(text, look_of(tone)))
                                            : std::string(text);
  }

  std::string operator()(const Row& row) const {
    return fmt::format("  {:<{}}{}\n", row.label, label_width, styled(row.tone, row.text));
  }

  /// Broken at spaces where it is longer than a page is wide.
  std::string operator()(const Line& line) const {
    std::string text;
    std::string_view rest = line.text;
    while (rest.size() > page_width) {
      const std::size_t space = rest.rfind(' ', page_width);
      if (space == std::string_view::npos) {
        break;
      }
      text += fmt::format("  {}\n", styled(line.tone, rest.substr(0, space)));
      rest.remove_prefix(space + 1);
    }
    return text + fmt::format("  {}\n", styled(line.tone, rest));
  }

  /// Columns as wide as their widest cell, the first and the last one to the left, the others to
  /// the right.
  std::string operator()(const Table& table) const {
    std::vector<std::size_t> widths(table.head.size());
    const auto widen = [&](const std::vector<std::string>& cells) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        widths[i] = std::max(widths[i], cells[i].size());
      }
    };
    widen(table.head);
    std::ranges::for_each(table.rows, widen, &TableRow::cells);
    std::string text = aligned({table.head}, widths);
    for (const TableRow& row : table.rows) {
      text += aligned(row, widths);
    }
    return text;
  }

 private:
  [[nodiscard]] std::string aligned(const TableRow& row,
                                    const std::vector<std::size_t>& widths) const {
    std::string text;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string& cell = row.cells[i];
      const bool last = i + 1 == row.cells.size();
      text += i == 0 ? "  " : "   ";
      text += last     ? styled(row.tone, cell)
              : i == 0 ? fmt::format("{:<{}}", cell, widths[i])
                       : fmt::format("{:>{}}", cell, widths[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  }

  bool coloured_;
};

}  // namespace

std::string text(const Document& document, const TextOptions& options) {
  const Text rendered(options.coloured);
  const std::string title = options.title.empty()
                                ? document.title
                                : fmt::format("{}: {}", document.title, spelled_out(options.title));
  std::string text = rendered.styled(Tone::heading, title) + "\n";
  if (!document.verdict.empty()) {
    text += rendered(Line{document.verdict, document.tone});
  }
  for (const Section& section : document.sections) {
    text += "\n" + rendered.styled(Tone::heading, section.heading) + "\n";
    for (const auto& part : section.parts) {
      text += std::visit(rendered, part);
    }
  }
  return text;
}

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
