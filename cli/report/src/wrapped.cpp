// SPDX-License-Identifier: MIT
#include <stillpoint/report/wrapped.hpp>

#include <algorithm>

namespace stillpoint::report {

namespace {

/// How the continuation of a line begins and how the line itself ends.
struct Fold {
  std::size_t indent{0};
  std::string_view end;
};

Fold fold_of(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::string_view words = line.substr(begin);
  if (begin > 0 && words.starts_with("stillpoint ")) {
    return {begin + 4, " \\"};
  }
  // "  --name VALUE     what it is for"
  const std::size_t gap = words.find("  ");
  if (begin > 0 && gap != std::string_view::npos) {
    return {begin + std::min(words.find_first_not_of(' ', gap), words.size()), ""};
  }
  return {begin, ""};
}

/// A number from its unit, "f = 0.02", or an option from its value.
bool parts(std::string_view text, std::size_t space) {
  constexpr std::string_view signs = "0123456789=<>+-";
  const std::string_view behind = text.substr(space + 1);
  if (space == 0 || behind.starts_with("--")) {
    return false;
  }
  const std::size_t before = text.rfind(' ', space - 1);
  const bool option = text.substr(before + 1, space - before - 1).starts_with("--");
  constexpr std::string_view relations = "=<>+-";
  return option || signs.find(text[space - 1]) != std::string_view::npos ||
         (!behind.empty() && relations.find(behind.front()) != std::string_view::npos);
}

/// The last blank up to `room` that parts nothing; any without one.
std::size_t last_blank(std::string_view text, std::size_t room, std::size_t least) {
  const std::size_t last = text.rfind(' ', room);
  for (std::size_t space = last; space != std::string_view::npos && space > least;
       space = text.rfind(' ', space - 1)) {
    if (!parts(text, space)) {
      return space;
    }
  }
  return last;
}

void add_line(std::string& text, std::string_view line, std::size_t width) {
  const Fold fold = fold_of(line);
  std::string now;
  std::string_view rest = line;
  while (now.size() + rest.size() > width) {
    const std::size_t room = width - std::min(width, now.size() + fold.end.size());
    const std::size_t first = std::min(rest.find_first_not_of(' '), rest.size());
    // A line must not break before the fold's column.
    const std::size_t least =
        now.empty() ? std::max(first, fold.end.empty() ? fold.indent : first) : first;
    std::size_t space = last_blank(rest, room, least);
    if (space == std::string_view::npos || space < least) {
      space = rest.find(' ', std::max(least, room));
    }
    if (space == std::string_view::npos) {
      break;
    }
    text += now;
    text += rest.substr(0, space);
    text += fold.end;
    text += '\n';
    now = std::string(fold.indent, ' ');
    rest.remove_prefix(space + 1);
  }
  text += now;
  text += rest;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    add_line(result, text.substr(0, end), width);
    if (end < text.size()) {
      result += '\n';
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace stillpoint::report
