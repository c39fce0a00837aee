// SPDX-License-Identifier: MIT
#include <stillpoint/report/document.hpp>

#include <stillpoint/records/text.hpp>
#include <stillpoint/report/wrapped.hpp>

#include <fmt/color.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace stillpoint::report {

namespace {

constexpr std::size_t label_width = 18;  // if no label of the section is longer
constexpr std::size_t page_width = 80;
constexpr std::size_t indent = 2;

fmt::text_style style_of(Tone tone) {
  static const std::array styles{fmt::text_style(), fmt::text_style(fmt::emphasis::bold),
                                 fmt::fg(fmt::terminal_color::green),
                                 fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red),
                                 fmt::text_style(fmt::emphasis::faint)};
  return styles.at(static_cast<std::size_t>(tone));
}

/// Renders the parts of a document.
class Text {
 public:
  explicit Text(bool coloured) : coloured_(coloured) {}

  [[nodiscard]] std::string styled(Tone tone, std::string_view text) const {
    return coloured_ && tone != Tone::plain ? fmt::format("{}", fmt::styled(text, style_of(tone)))
                                            : std::string(text);
  }

  [[nodiscard]] std::string heading(std::string_view words) const {
    return lines(Tone::heading, "", words, page_width);
  }

  std::string operator()(const Row& row) const {
    const std::string label = fmt::format("  {:<{}}", row.label, label_width_);
    return lines(row.tone, label, row.text, page_width - label.size());
  }

  std::string operator()(const Line& line) const {
    return lines(line.tone, "  ", line.text, page_width - indent);
  }

  std::string operator()(const Section& section) {
    constexpr std::size_t least_gap = 2;
    label_width_ = label_width;
    for (const auto& part : section.parts) {
      const Row* const row = std::get_if<Row>(&part);
      label_width_ = std::max(label_width_, row != nullptr ? row->label.size() + least_gap : 0);
    }
    std::string text;
    for (const auto& part : section.parts) {
      text += std::visit(*this, part);
    }
    return text;
  }

  /// Columns as wide as their widest cell, to the right; to the left the first and, unless it has
  /// only numbers, the last one, whose words continue below. A table that is too wide gets its
  /// heads in two lines and smaller gaps.
  std::string operator()(const Table& table) {
    ends_in_numbers_ = std::ranges::all_of(table.rows, [](const TableRow& row) {
      return row.cells.back() == "none" ||
             row.cells.back().find_first_not_of("0123456789.e+-") == std::string::npos;
    });
    std::vector<TableRow> rows{{table.head}};
    gap_ = usual_gap;
    if (width_of(set_widths(rows, table)) > page_width) {
      rows = in_two_lines(table.head);
      set_widths(rows, table);
    }
    while (gap_ > 1 && width_of(widths_) > page_width) {
      --gap_;
    }
    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    std::string text;
    for (const TableRow& row : rows) {
      const std::string line = aligned(row);
      text += line == "\n" ? "" : line;
    }
    return text;
  }

 private:
  static constexpr std::size_t usual_gap = 3;  // between columns

  /// In lines of at most `width`, if the words allow it; all but the first are indented as far.
  [[nodiscard]] std::string lines(Tone tone, std::string before, std::string_view words,
                                  std::size_t width) const {
    std::string text;
    const std::string folded = wrapped(words, width);
    for (const std::string_view line : records::split(folded, '\n')) {
      text += before + styled(tone, line);
      text.erase(text.find_last_not_of(' ') + 1);
      text += "\n";
      before.assign(before.size(), ' ');
    }
    return text;
  }

  [[nodiscard]] std::size_t width_of(const std::vector<std::size_t>& widths) const {
    return std::accumulate(widths.begin(), widths.end(), indent + (widths.size() - 1) * gap_);
  }

  /// Words of the last column have the room that is left, but at least 24.
  const std::vector<std::size_t>& set_widths(const std::vector<TableRow>& heads,
                                             const Table& table) {
    constexpr std::size_t least = 24;
    widths_.assign(table.head.size(), 0);
    for (const auto* const rows : {&heads, &table.rows}) {
      for (const TableRow& row : *rows) {
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
          widths_[i] = std::max(widths_[i], row.cells[i].size());
        }
      }
    }
    if (!ends_in_numbers_) {
      const std::size_t others = std::min(width_of(widths_) - widths_.back(), page_width);
      widths_.back() = std::min(widths_.back(), std::max(least, page_width - others));
    }
    return widths_;
  }

  /// "peak, mm" in two lines; the second is empty where all heads are single words.
  static std::vector<TableRow> in_two_lines(const std::vector<std::string>& heads) {
    std::vector<TableRow> rows(2);
    for (const std::string& head : heads) {
      constexpr std::size_t room = 10;
      const std::size_t unit = head.find(", ");
      const std::size_t end = unit <= room ? unit : std::min(head.find_first_of(", "), head.size());
      rows[0].cells.push_back(head.substr(0, end));
      rows[1].cells.push_back(
          head.substr(std::min(head.find_first_not_of(", ", end), head.size())));
    }
    return rows;
  }

  [[nodiscard]] std::string aligned(const TableRow& row) const {
    std::string text(indent, ' ');
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string& cell = row.cells[i];
      const bool last = i + 1 == row.cells.size();
      if (last && !ends_in_numbers_) {
        return lines(row.tone, text, cell, widths_[i]);
      }
      const std::string room(widths_[i] - cell.size(), ' ');
      const std::string placed = i == 0 ? cell + room : room + cell;
      text += last ? styled(row.tone, placed) : placed + std::string(gap_, ' ');
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  }

  std::size_t gap_{usual_gap};
  std::vector<std::size_t> widths_;  ///< of the table at hand
  bool coloured_;
  std::size_t label_width_{label_width};
  bool ends_in_numbers_{false};  ///< the table at hand
};

}  // namespace

std::string text(const Document& document, const TextOptions& options) {
  Text rendered(options.coloured);
  const std::string title = options.title.empty()
                                ? document.title
                                : fmt::format("{}: {}", document.title, spelled_out(options.title));
  std::string text = rendered.heading(title);
  if (!document.verdict.empty()) {
    text += rendered(Line{document.verdict, document.tone});
  }
  if (!document.answer.parts.empty()) {
    text += "\n" + rendered(document.answer);
  }
  for (const Section& section : document.sections) {
    if (section.parts.empty() || (section.detail && document.brief)) {
      continue;
    }
    text += "\n" + rendered.heading(section.heading) + rendered(section);
  }
  if (document.brief) {
    text += "\n" + rendered(Line{"--verbose shows more.", Tone::faint});
  }
  return text;
}

Table without_empty_columns(Table table) {
  for (std::size_t i = table.head.size(); i-- > 0;) {
    if (std::ranges::all_of(table.rows, [i](const auto& row) { return row.cells[i].empty(); })) {
      const auto at = static_cast<std::ptrdiff_t>(i);
      table.head.erase(table.head.begin() + at);
      for (TableRow& row : table.rows) {
        row.cells.erase(row.cells.begin() + at);
      }
    }
  }
  return table;
}

std::string spelled_out(std::string_view text) {
  constexpr unsigned of_one_byte = 0x100;
  const auto spelled = [](unsigned code) {
    return code < of_one_byte ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
  };
  return records::with_controls_as(spelled, text);
}

}  // namespace stillpoint::report
