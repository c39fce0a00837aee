// SPDX-License-Identifier: MIT
#pragma once

// A report for people, as data. It is described once, and rendered as text and as HTML.

#include <stillpoint/figures/html_page.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace stillpoint::report {

enum class Tone { plain, heading, good, bad, faint };

struct Row {
  std::string label;  ///< empty: continues the row above
  std::string text;
  Tone tone{Tone::plain};
};

/// A paragraph.
struct Line {
  std::string text;
  Tone tone{Tone::plain};
};

struct TableRow {
  std::vector<std::string> cells;
  Tone tone{Tone::plain};  ///< of the last cell
};

struct Table {
  std::vector<std::string> head;
  std::vector<TableRow> rows;
};

/// Without the columns of which all cells are empty.
[[nodiscard]] Table without_empty_columns(Table table);

struct Section {
  using Part = std::variant<Row, Line, Table>;

  std::string heading;
  std::vector<Part> parts;
  bool detail{false};  ///< for those who want to know more than the answer
  bool folded{false};  ///< on a page, until it is opened

  void row(std::string label, std::string text, Tone tone = Tone::plain) {
    parts.emplace_back(Row{std::move(label), std::move(text), tone});
  }
  /// Nothing without a text.
  void line(std::string text, Tone tone = Tone::plain) {
    if (!text.empty()) {
      parts.emplace_back(Line{std::move(text), tone});
    }
  }
};

struct Document {
  std::string title;
  std::string verdict;     ///< the answer, in a sentence or two
  Tone tone{Tone::plain};  ///< of the verdict
  Section answer{};        ///< the rest of the answer, without a heading
  std::vector<Section> sections{};
  bool brief{false};  ///< without the details of its report

  /// A new section at the end; the reference is good until the next one.
  Section& section(std::string heading, std::vector<Section::Part> parts = {}) {
    return sections.emplace_back(Section{std::move(heading), std::move(parts)});
  }
  Section& detail(std::string heading) {
    return sections.emplace_back(Section{std::move(heading), {}, true, true});
  }
};

/// Of a report that has some.
template <class Report>
[[nodiscard]] auto findings(const Report& report) -> decltype((report.findings)) {
  return report.findings;
}
template <class Report>
[[nodiscard]] auto findings(const Report& report) -> decltype((report.result.findings)) {
  return report.result.findings;
}

/// Of a report that has verdict(), without its rows.
template <class Report>
[[nodiscard]] Document answered(const std::string& title, const Report& report, Tone tone) {
  return {.title = title, .verdict = verdict(report), .tone = tone};
}

/// How much of a document the text shows: the answer without details, or everything.
enum class Verbosity { normal, full };

/// The objects of a report's JSON, which docs/reports.md describes, as sections of details.
void add_details(Document& document, const nlohmann::ordered_json& report);

/// Of a report that has document() and json(), which is made only for details.
template <class Report>
[[nodiscard]] Document document(const Report& report, Verbosity verbosity) {
  Document made = document(report);
  made.brief = verbosity == Verbosity::normal;
  if (!made.brief) {
    add_details(made, json(report));
  }
  return made;
}

struct TextOptions {
  std::string title{};   ///< the scene's own, after that of the document
  bool coloured{false};  ///< for a terminal
};

/// For a terminal or a file, at most 80 columns wide if words and tables allow it: the answer, then
/// headed sections of aligned columns. Control characters in the title are spelled out.
[[nodiscard]] std::string text(const Document& document, const TextOptions& options = {});

/// The sections after the answer as HTML, without a page around them.
[[nodiscard]] std::string html(const Document& document);
/// One of them, or the answer, without its heading.
[[nodiscard]] std::string html(const Section& section);

/// Its page, without figures.
[[nodiscard]] figures::HtmlPage page_of(const Document& document);

/// The page of a report with its drawings(), if it has any. The caller adds title, input and
/// footer.
template <class Report>
[[nodiscard]] figures::HtmlPage page(const Report& report) {
  figures::HtmlPage made = page_of(document(report, Verbosity::full));
  if constexpr (requires { drawings(report); }) {
    made.figures = drawings(report);
  }
  return made;
}

/// Control characters and marks of direction, which could break a line or play tricks with a
/// terminal, as \\xNN or \\uNNNN.
[[nodiscard]] std::string spelled_out(std::string_view text);

}  // namespace stillpoint::report
