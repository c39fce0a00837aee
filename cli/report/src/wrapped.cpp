// SPDX-License-Identifier: MIT
#include <stillpoint/report/wrapped.hpp>

#include <algorithm>

namespace stillpoint::report {

namespace {

/// How a line is folded: what begins it stays whole, what continues it is indented.
struct Fold {
  std::size_t whole{0};
  std::size_t indent{0};
  std::string_view end;  ///< of the line itself
};

Fold fold_of(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  if (begin > 0 && line.substr(begin).starts_with("stillpoint ")) {
    return {begin, begin + 4, " \\"};
  }
  // "  --name VALUE     what it is for"
  const std::size_t gap = begin > 0 ? line.find("  ", begin) : std::string_view::npos;
  const std::size_t column =
      gap < line.size() ? std::min(line.find_first_not_of(' ', gap), line.size()) : begin;
  return {column, column, ""};
}

/// A number from its unit, "f = 0.02", or an option from its value.
bool parts(std::string_view text, std::size_t space) {
  constexpr std::string_view signs = "0123456789=<>+-";
  const std::string_view behind = text.substr(space + 1);
  if (space == 0 || behind.starts_with("--") || behind.starts_with('(')) {
    return false;
  }
  const std::size_t before = text.rfind(' ', space - 1);
  const bool option = text.substr(before + 1, space - before - 1).starts_with("--");
  constexpr std::string_view relations = "=<>+-";
  return option || signs.find(text[space - 1]) != std::string_view::npos ||
         (!behind.empty() && relations.find(behind.front()) != std::string_view::npos);
}

/// The last blank up to `room` that parts nothing; else the last or, beyond it, the next one.
std::size_t last_blank(std::string_view text, std::size_t room) {
  const std::size_t last = text.rfind(' ', room);
  std::size_t space = last;
  while (space != std::string_view::npos && parts(text, space)) {
    space = space == 0 ? std::string_view::npos : text.rfind(' ', space - 1);
  }
  return space != std::string_view::npos  ? space
         : last != std::string_view::npos ? last
                                          : text.find(' ', room);
}

void add_line(std::string& text, std::string_view line, std::size_t width) {
  const Fold fold = fold_of(line);
  std::string now(line.substr(0, fold.whole));
  std::string_view rest = line.substr(fold.whole);
  while (now.size() + rest.size() > width) {
    const std::size_t space =
        last_blank(rest, width - std::min(width, now.size() + fold.end.size()));
    if (space == std::string_view::npos) {
      break;
    }
    text += now.append(rest.substr(0, space)).append(fold.end) + '\n';
    now.assign(fold.indent, ' ');
    rest.remove_prefix(space + 1);
  }
  text += now.append(rest);
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
