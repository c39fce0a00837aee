// SPDX-License-Identifier: MIT
#include <stillpoint/report/document.hpp>

#include <stillpoint/records/text.hpp>
#include <stillpoint/report/wrapped.hpp>

#include <fmt/color.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <variant>

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
      if (const Row* const row = std::get_if<Row>(&part)) {
        label_width_ = std::max(label_width_, row->label.size() + least_gap);
      }
    }
    std::string text;
    for (const auto& part : section.parts) {
      text += std::visit(*this, part);
    }
    return text;
  }

  /// Columns as wide as their widest cell, to the right; to the left the first and, unless it has
  /// only numbers, the last one, whose words continue below. A table that is too wide gets its
  /// heads in two lines and smaller gaps, and where even that is not enough, long names above their
  /// rows.
  std::string operator()(Table table) {
    ends_in_numbers_ = std::ranges::all_of(table.rows, [](const TableRow& row) {
      return row.cells.back() == "none" ||
             row.cells.back().find_first_not_of("0123456789.e+-") == std::string::npos;
    });
    std::vector<std::vector<std::string>> heads{table.head};
    std::size_t gap = usual_gap;
    std::vector<std::size_t> widths = widths_of(heads, table);
    if (width(widths, gap) > page_width) {
      heads = in_two_lines(table.head);
      widths = widths_of(heads, table);
    }
    while (gap > 1 && width(widths, gap) > page_width) {
      --gap;
    }
    if (width(widths, gap) > page_width) {
      gap = 2;
      widths[0] = std::max(heads.front()[0].size(), heads.back()[0].size());
    }
    std::string text;
    for (const std::vector<std::string>& head : heads) {
      const std::string line = aligned({head}, widths, gap);
      text += line == "\n" ? "" : line;
    }
    for (TableRow& row : table.rows) {
      if (row.cells[0].size() > widths[0]) {
        text += fmt::format("  {}\n", std::exchange(row.cells[0], ""));
      }
      text += aligned(row, widths, gap);
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

  static std::size_t width(const std::vector<std::size_t>& columns, std::size_t gap) {
    return std::accumulate(columns.begin(), columns.end(), 2 + (columns.size() - 1) * gap);
  }

  /// Of the columns; words of the last one have the room that is left, but at least 30.
  [[nodiscard]] std::vector<std::size_t> widths_of(
      const std::vector<std::vector<std::string>>& heads, const Table& table) const {
    std::vector<std::size_t> widths(table.head.size());
    const auto widen = [&widths](const std::vector<std::string>& cells) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        widths[i] = std::max(widths[i], cells[i].size());
      }
    };
    std::ranges::for_each(heads, widen);
    std::ranges::for_each(table.rows, widen, &TableRow::cells);
    if (!ends_in_numbers_) {
      constexpr std::size_t least = 30;
      const std::size_t others = std::min(width(widths, usual_gap) - widths.back(), page_width);
      widths.back() = std::min(widths.back(), std::max(least, page_width - others));
    }
    return widths;
  }

  /// "peak, mm" in two lines; the second is empty where all heads are single words.
  static std::vector<std::vector<std::string>> in_two_lines(const std::vector<std::string>& heads) {
    std::vector<std::vector<std::string>> lines(2);
    for (const std::string& head : heads) {
      constexpr std::size_t room = 10;
      const std::size_t unit = head.find(", ");
      const std::size_t end =
          unit <= room ? unit : std::min(head.find_first_of(", -"), head.size());
      lines[0].push_back(head.substr(0, end) + (head[end] == '-' ? "-" : ""));
      lines[1].push_back(head.substr(std::min(head.find_first_not_of(", -", end), head.size())));
    }
    return lines;
  }

  [[nodiscard]] std::string aligned(const TableRow& row, const std::vector<std::size_t>& widths,
                                    std::size_t gap) const {
    std::string text;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string& cell = row.cells[i];
      const bool last = i + 1 == row.cells.size();
      text += std::string(i == 0 ? 2 : gap, ' ');
      if (last && !ends_in_numbers_) {
        return lines(row.tone, text, cell, widths[i]);
      }
      const std::string placed =
          i == 0 ? fmt::format("{:<{}}", cell, widths[i]) : fmt::format("{:>{}}", cell, widths[i]);
      text += last ? styled(row.tone, placed) : placed;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  }

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
    const auto at = static_cast<std::ptrdiff_t>(i);
    if (std::ranges::all_of(table.rows,
                            [i](const TableRow& row) { return row.cells[i].empty(); })) {
      table.head.erase(table.head.begin() + at);
      std::ranges::for_each(table.rows,
                            [at](TableRow& row) { row.cells.erase(row.cells.begin() + at); });
    }
  }
  return table;
}

void Section::row(std::string label, std::string text, Tone tone) {
  parts.emplace_back(Row{std::move(label), std::move(text), tone});
}

void Section::line(std::string text, Tone tone) {
  if (!text.empty()) {
    parts.emplace_back(Line{std::move(text), tone});
  }
}

Section& Document::section(std::string heading) {
  return sections.emplace_back(Section{std::move(heading), {}});
}

Section& Document::section(std::string heading, Table table) {
  return sections.emplace_back(Section{std::move(heading), {std::move(table)}});
}

Section& Document::detail(std::string heading) {
  return sections.emplace_back(Section{std::move(heading), {}, true});
}

std::string spelled_out(std::string_view text) {
  constexpr unsigned of_one_byte = 0x100;
  const auto spelled = [](unsigned code) {
    return code < of_one_byte ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
  };
  return records::with_controls_as(spelled, text);
}

}  // namespace stillpoint::report
