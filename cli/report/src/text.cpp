// SPDX-License-Identifier: MIT
#include <stillpoint/report/document.hpp>

#include <fmt/color.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace stillpoint::report {

namespace {

constexpr std::size_t label_width = 18;
constexpr std::size_t page_width = 80;
constexpr std::size_t indent = 2;

/// A line does not end within "f = 0.02" or "5.9 mm": what ends it is a word or a mark.
bool may_end(std::string_view text, std::size_t space) {
  constexpr std::string_view relations = "=<>+-";
  constexpr std::string_view digits = "0123456789";
  return digits.find(text[space - 1]) == std::string_view::npos &&
         relations.find(text[space - 1]) == std::string_view::npos &&
         relations.find(text[space + 1]) == std::string_view::npos;
}

/// `text` in lines of at most `width`, where its words allow it.
std::vector<std::string_view> lines_of(std::string_view text, std::size_t width) {
  std::vector<std::string_view> lines;
  while (text.size() > width) {
    std::size_t space = text.rfind(' ', width);
    while (space != std::string_view::npos && space > 0 && !may_end(text, space)) {
      space = text.rfind(' ', space - 1);
    }
    if (space == std::string_view::npos || space == 0) {
      break;
    }
    lines.push_back(text.substr(0, space));
    text.remove_prefix(space + 1);
  }
  lines.push_back(text);
  return lines;
}

fmt::text_style style_of(Tone tone) {
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
    return coloured_ && tone != Tone::plain ? fmt::format("{}", fmt::styled(text, style_of(tone)))
                                            : std::string(text);
  }

  std::string operator()(const Row& row) const {
    std::string text;
    std::string_view label = row.label;
    for (const auto line : lines_of(row.text, page_width - indent - label_width)) {
      text += fmt::format("  {:<{}}{}\n", label, label_width, styled(row.tone, line));
      label = "";
    }
    return text;
  }

  std::string operator()(const Line& line) const {
    std::string text;
    for (const auto part : lines_of(line.text, page_width - indent)) {
      text += fmt::format("  {}\n", styled(line.tone, part));
    }
    return text;
  }

  std::string operator()(const Section& section) const {
    std::string text;
    for (const auto& part : section.parts) {
      text += std::visit(*this, part);
    }
    return text;
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
    std::ranges::for_each(table.rows, widen, &TableRow::cells);
    const std::vector<std::size_t> narrow = widths;
    widen(table.head);
    std::vector<std::vector<std::string>> heads{table.head};
    if (width(widths, usual_gap) > page_width) {
      heads = units_below(table.head);
      widths = narrow;
      std::ranges::for_each(heads, widen);
    }
    const std::size_t gap = width(widths, usual_gap) > page_width ? narrow_gap : usual_gap;
    std::string text;
    for (const std::vector<std::string>& head : heads) {
      text += aligned({head}, widths, gap);
    }
    for (const TableRow& row : table.rows) {
      text += aligned(row, widths, gap);
    }
    return text;
  }

 private:
  static constexpr std::size_t usual_gap = 3;  // between columns
  static constexpr std::size_t narrow_gap = 2;

  static std::size_t width(const std::vector<std::size_t>& columns, std::size_t gap) {
    return std::accumulate(columns.begin(), columns.end(), 2 + (columns.size() - 1) * gap);
  }

  /// "peak, mm" in two lines; one line where no head has a unit.
  static std::vector<std::vector<std::string>> units_below(const std::vector<std::string>& heads) {
    std::vector<std::vector<std::string>> lines(2);
    bool any = false;
    for (const std::string& head : heads) {
      const std::size_t comma = head.find(", ");
      any = any || comma != std::string::npos;
      lines[0].push_back(head.substr(0, comma));
      lines[1].push_back(comma == std::string::npos ? "" : head.substr(comma + 2));
    }
    lines.resize(any ? 2 : 1);
    return lines;
  }

  [[nodiscard]] std::string aligned(const TableRow& row, const std::vector<std::size_t>& widths,
                                    std::size_t gap) const {
    std::string text;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string& cell = row.cells[i];
      const bool last = i + 1 == row.cells.size();
      text += std::string(i == 0 ? 2 : gap, ' ');
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
  if (!document.answer.parts.empty()) {
    text += "\n" + rendered(document.answer);
  }
  bool more = false;
  for (const Section& section : document.sections) {
    if (section.detail && options.verbosity == Verbosity::normal) {
      more = true;
      continue;
    }
    text += "\n" + rendered.styled(Tone::heading, section.heading) + "\n" + rendered(section);
  }
  if (more) {
    text += "\n" + rendered(Line{"--verbose says more.", Tone::faint});
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

Section& Document::detail(std::string heading) {
  return sections.emplace_back(Section{std::move(heading), {}, true});
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
