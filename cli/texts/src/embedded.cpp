// SPDX-License-Identifier: MIT
#include <stillpoint/texts/embedded.hpp>

#include <algorithm>
#include <cassert>

namespace stillpoint::texts {

std::string_view embedded(std::string_view file) {
  static const std::map<std::string_view, std::string_view> files{
#include "embedded.inc"
  };
  assert(files.contains(file) && "a file that the program does not have");
  return files.at(file);
}

std::string embedded(std::string_view file, const std::map<std::string_view, std::string>& texts) {
  std::string result;
  std::string_view rest = embedded(file);
  for (;;) {
    const std::size_t at = rest.find('@');
    const std::size_t end = rest.find('@', at + 1);
    if (std::max(at, end) == std::string_view::npos) {
      return result.append(rest);
    }
    result += rest.substr(0, at);
    result += texts.at(rest.substr(at + 1, end - at - 1));
    rest.remove_prefix(end + 1);
  }
}

std::string_view line_of(std::string_view file, std::string_view name) {
  for (std::string_view rest = embedded(file); !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    if (line.starts_with(name) && line.substr(name.size()).starts_with(": ")) {
      return line.substr(name.size() + 2);
    }
    rest.remove_prefix(line.size() + 1);
  }
  assert(false && "a line that the file does not have");
  return {};
}

}  // namespace stillpoint::texts
