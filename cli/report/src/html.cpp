// SPDX-License-Identifier: MIT
#include <stillpoint/figures/figure.hpp>

#include <stillpoint/report/document.hpp>
#include "format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace stillpoint::report {

namespace {

using figures::escaped;

bool in_name(char c) {
  constexpr std::string_view others = "_-";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         others.find(c) != std::string_view::npos;
}

/// With the letters of the figures in place of "delta" and so on, but not in "--delta-max" or in
/// the name of a file.
std::string lettered(std::string_view text) {
  static constexpr auto letters =
      std::to_array<std::pair<std::string_view, std::string_view>>({{"delta1", "Δ₁"},
                                                                    {"delta", "Δ"},
                                                                    {"tau", "τ"},
                                                                    {"lambda", "λ"},
                                                                    {"v0", "V₀"},
                                                                    {"x0", "x₀"},
                                                                    {"f2", "f₂"},
                                                                    {"f3", "f₃"},
                                                                    {"E_s", "Eₛ"},
                                                                    {"E_h", "Eₕ"},
                                                                    {"d_rm", "dᵣₘ"}});
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const auto length = static_cast<std::size_t>(
        std::find_if_not(rest.begin(), rest.end(), in_name) - rest.begin());
    const std::size_t end = at + length;
    const std::string_view word = rest.substr(0, length);
    const bool path = (at > 0 && text[at - 1] == '/') ||
                      (end + 1 < text.size() && text[end] == '.' && in_name(text[end + 1]));
    const auto* const letter =
        std::ranges::find(letters, word, &std::pair<std::string_view, std::string_view>::first);
    shown += letter == letters.end() || path ? word : letter->second;
    shown += text.substr(end, 1);
    at = end + 1;
  }
  return shown;
}

std::string prose(std::string_view text) {
  return figures::prose(lettered(text));
}

/// The class that the page's style knows.
std::string_view look_of(Tone tone) {
  static constexpr auto looks = std::to_array<std::string_view>(
      {"", " class=\"key\"", " class=\"good\"", " class=\"bad\"", " class=\"faint\""});
  return looks.at(static_cast<std::size_t>(tone));
}

/// "peak, mm" before and after a number of its column, on narrow screens, where a row is a
/// paragraph.
std::string around(const std::string& head, const std::string& cell) {
  const std::size_t comma = std::min(head.find(", "), head.size());
  std::string text =
      head.empty() ? "" : format(" data-head=\"{}\"", escaped(lettered(head.substr(0, comma))));
  if (comma < head.size() && cell.find_first_of("0123456789") != std::string::npos) {
    text += format(" data-unit=\"{}\"", escaped(head.substr(comma + 2)));
  }
  return text;
}

std::string cells(const TableRow& row, const std::vector<std::string>& head) {
  std::string text = row.tone == Tone::bad ? "<tr class=\"violated\">" : "<tr>";
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const bool last = i + 1 == row.cells.size();
    text += format("<td{}{}>{}</td>", row.cells[i].empty() ? "" : around(head[i], row.cells[i]),
                   last ? look_of(row.tone) : "", prose(row.cells[i]));
  }
  return text + "</tr>\n";
}

/// "peak, mm", whose unit does not stand alone on a line.
std::string head_of(std::string_view name) {
  std::string text = escaped(lettered(name));
  if (const std::size_t unit = text.rfind(", "); unit != std::string::npos) {
    text.replace(unit + 1, 1, "\u00a0");
  }
  return text;
}

/// Whether it has a table too wide for half a page.
bool is_wide(const Section& section) {
  constexpr std::size_t most = 4;  // columns
  return std::ranges::any_of(section.parts, [](const auto& part) {
    const Table* const table = std::get_if<Table>(&part);
    return table != nullptr && table->head.size() > most;
  });
}

std::string html_of(const Row& row) {
  return format("<tr><th>{}</th><td{}>{}</td></tr>\n", escaped(lettered(row.label)),
                look_of(row.tone), prose(row.text));
}

std::string html_of(const Line& line) {
  return format("<p{}>{}</p>\n", look_of(line.tone), prose(line.text));
}

std::string html_of(const Table& table) {
  std::string text = "<div class=\"wide\"><table class=\"columns\">\n<thead><tr>";
  for (const std::string& name : table.head) {
    text += format("<th>{}</th>", head_of(name));
  }
  text += "</tr></thead>\n";
  for (const TableRow& row : table.rows) {
    text += cells(row, table.head);
  }
  return text + "</table></div>\n";
}

}  // namespace

std::string html(const Section& section) {
  std::string text;
  bool in_rows = false;  // which are one table
  const auto begin_or_end = [&](bool rows) {
    text += rows == in_rows ? ""
            : rows          ? "<div class=\"wide\"><table class=\"rows\">\n"
                            : "</table></div>\n";
    in_rows = rows;
  };
  for (const auto& part : section.parts) {
    begin_or_end(std::holds_alternative<Row>(part));
    text += std::visit([](const auto& of) { return html_of(of); }, part);
  }
  begin_or_end(false);
  return text;
}

std::string html(const Document& document) {
  std::string text;
  for (const Section& section : document.sections) {
    if (section.parts.empty()) {
      continue;
    }
    const std::string look = is_wide(section) ? " class=\"across\"" : "";
    const std::string title = escaped(section.heading);
    text +=
        section.folded
            ? format("<details{}><summary>{}</summary>\n{}</details>\n", look, title, html(section))
            : format("<section{}><h2>{}</h2>\n{}</section>\n", look, title, html(section));
  }
  return text;
}

figures::HtmlPage page_of(const Document& document) {
  return {.title = document.title,
          .verdict = lettered(document.verdict),
          .alarming = document.tone == Tone::bad,
          .answer = html(document.answer),
          .figures = {},
          .body = html(document),
          .report = text(document),
          .footer = {}};
}

}  // namespace stillpoint::report
