// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace stillpoint::test {

/// With the characters that \n, \r, \t, \xNN and \\ stand for, and
/// \{20 ab} for 20 times ab, as tables of tests write them.
inline std::string unescaped(const std::string& text) {
  static const std::map<char, char> letters{{'n', '\n'}, {'r', '\r'}, {'t', '\t'}, {'\\', '\\'}};
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      plain += text[i];
    } else if (text.at(++i) == '{') {
      const std::size_t blank = text.find(' ', i);
      const std::size_t end = text.find('}', blank);
      for (int n = std::stoi(text.substr(i + 1, blank - i)); n > 0; --n) {
        plain += text.substr(blank + 1, end - blank - 1);
      }
      i = end;
    } else if (text[i] == 'x') {
      plain += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      plain += letters.at(text[i]);
    }
  }
  return plain;
}

}  // namespace stillpoint::test
