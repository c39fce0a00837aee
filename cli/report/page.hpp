// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// Control characters, which could break a line or play tricks with a terminal, as \\xNN.
[[nodiscard]] std::string spelled_out(std::string_view text);

enum class Tone { plain, heading, good, bad, faint };

/// Text in a tone, coloured for a terminal or as it is.
class Style {
 public:
  explicit Style(bool coloured) : coloured_(coloured) {}
  [[nodiscard]] std::string operator()(Tone tone, std::string_view text) const;

 private:
  bool coloured_;
};

/// Colour only where standard output is a terminal and NO_COLOR is not set (or empty) and TERM is
/// not "dumb".
[[nodiscard]] Style style_for_standard_output();

/// A report for people: headed sections of aligned columns.
class Page {
 public:
  explicit Page(Style style) : style_(style) {}

  void title(std::string_view text);
  void section(std::string_view heading);
  /// "  label      text"
  void row(std::string_view label, std::string_view text, Tone tone = Tone::plain);
  /// Broken at spaces where it is longer than a page is wide.
  void line(std::string_view text, Tone tone = Tone::plain);
  /// Columns as wide as their widest cell, the first one to the left, the others to the right; the
  /// last one to the left again. `tones` has one entry for each row, of its last cell.
  void table(const std::vector<std::vector<std::string>>& rows, const std::vector<Tone>& tones);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  Style style_;
  std::string text_;
};

/// Six significant digits: "0.259325", "1.2e-09".
[[nodiscard]] std::string figure(double value);
/// The same, or "none".
[[nodiscard]] std::string figure(const std::optional<double>& value);
/// A figure with a unit and the prefix that fits: "12.1 mm", "3.46 kN".
[[nodiscard]] std::string with_unit(double value, std::string_view unit);
/// In ten significant digits, none below the value (upwards) or none above it: a limit stays kept.
[[nodiscard]] std::string limit_figure(double value, bool upwards);
/// "1 turning point", "2 turning points".
[[nodiscard]] std::string plural(const std::optional<double>& count, std::string_view one);
/// A count in full up to 2^53, as a power of ten beyond.
[[nodiscard]] std::string whole(const std::optional<double>& value);

}  // namespace stillpoint::cli
