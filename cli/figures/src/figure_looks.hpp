// SPDX-License-Identifier: MIT
#pragma once

// The classes and outlines of inks, dashes, shapes and fills in the SVG.

#include <stillpoint/figures/figure.hpp>

#include <fmt/format.h>

#include <array>
#include <iterator>

namespace stillpoint::figures {

inline constexpr std::array<std::string_view, 7> ink_words{"blue", "orange", "green", "purple",
                                                           "sky",  "amber",  "grey"};
inline constexpr std::array<std::string_view, 3> dash_words{"", " dashed", " dotted"};
inline constexpr std::array<std::string_view, 4> look_words{"band", "area", "hatched", "box"};
/// Centred at (0, 0).
inline constexpr std::array<std::string_view, 7> outlines{
    "M-3.8 0A3.8 3.8 0 1 1 3.8 0A3.8 3.8 0 1 1-3.8 0Z",
    "M-3.5-3.5H3.5V3.5H-3.5Z",
    "M0-5.4L4.6 0L0 5.4L-4.6 0Z",
    "M-7 0L-2.1-2.1L0-7L2.1-2.1L7 0L2.1 2.1L0 7L-2.1 2.1Z",
    "M0-4.6L4.4 3.4H-4.4Z",
    "M0 4.6L4.4-3.4H-4.4Z",
    "M-4-4L4 4M4-4L-4 4"};

/// That of an enumerator.
template <class Kind, std::size_t count>
std::string_view of(const std::array<std::string_view, count>& words, Kind kind) {
  return words.at(static_cast<std::size_t>(kind));
}

/// The path of a mark; `place` is an attribute or empty.
inline std::string mark(const FigureMarks& marks, std::string_view place = {}) {
  const bool filled = marks.fill == Fill::solid && marks.shape != Shape::cross;
  return fmt::format(R"(<path class="{} {}"{} d="{}"/>)", filled ? "disc" : "ring",
                     of(ink_words, marks.ink), place, of(outlines, marks.shape));
}

/// The beginning of what keeps its size when a page zooms.
inline std::string pin(const FigurePoint& at) {
  return fmt::format("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\"", at.x, at.y);
}

template <class... Args>
void add(std::string& text, fmt::format_string<Args...> what, Args&&... args) {
  fmt::format_to(std::back_inserter(text), what, std::forward<Args>(args)...);
}

}  // namespace stillpoint::figures
