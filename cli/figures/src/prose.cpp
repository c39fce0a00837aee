// SPDX-License-Identifier: MIT
// Text as it is printed: special characters escaped, and no line break where it would tear a number
// from its unit or an equation apart.
#include <stillpoint/figures/figure.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace stillpoint::figures {

namespace {

using Replaced = std::pair<std::string_view, std::string_view>;

std::string replaced(std::string text, std::initializer_list<Replaced> all) {
  for (const auto& [from, to] : all) {
    for (std::size_t i = text.find(from); i != std::string::npos;
         i = text.find(from, i + to.size())) {
      text.replace(i, from.size(), to);
    }
  }
  return text;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool begins_number(std::string_view word) {
  return !word.empty() && (is_digit(word.front()) || word.front() == '-');
}

bool begins_unit(std::string_view word) {
  const char first = word.empty() ? ' ' : word.front();
  return first == '%' || word.starts_with("\u00b5") || ((first | 32) >= 'a' && (first | 32) <= 'z');
}

bool is_operator(std::string_view word) {
  constexpr auto all =
      std::to_array<std::string_view>({">=", "\u2265", "<=", "\u2264", ">", "<", "+", "-"});
  return std::ranges::find(all, word) != all.end();
}

/// Browsers break "6.2e-09" and "1998-2" after the hyphen.
bool breaks_in_number(std::string_view word) {
  for (std::size_t i = 1; i + 1 < word.size(); ++i) {
    const bool exponent = i > 1 && word[i - 1] == 'e' && is_digit(word[i - 2]);
    if (word[i] == '-' && is_digit(word[i + 1]) && (exponent || is_digit(word[i - 1]))) {
      return true;
    }
  }
  return false;
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t end = text.find(' '); end != std::string_view::npos; end = text.find(' ')) {
    words.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  words.push_back(text);
  return words;
}

/// For each word whether it stays with the next: "9.81 m/s2", "EN 15129", "f ≥ 0.02", "f +
/// delta/w" and "f = 0.02"; of "0.03 = 5.9 mm" what follows the first number.
std::vector<bool> bound(const std::vector<std::string_view>& words) {
  std::vector<bool> stays(words.size());
  std::string_view value;  // with its unit
  bool measures = false;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string_view next = words[i + 1];
    const bool leads = i + 2 < words.size();
    value = measures ? value : words[i];
    measures = !words[i].empty() && is_digit(words[i].back()) && begins_unit(next);
    const bool equals = leads && next == "=" && begins_number(words[i + 2]);
    const bool compares = leads && is_operator(next);
    stays[i] = stays[i] || measures || compares || words[i].ends_with("EN") ||
               (equals && !begins_number(value));
    stays[i + 1] = equals || compares;
  }
  return stays;
}

}  // namespace

std::string escaped(std::string_view text) {
  return replaced(std::string(text),
                  {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}});
}

std::string prose(std::string_view text) {
  constexpr std::size_t longest = 40;  // of what fits a narrow screen
  const auto words = split(text);
  const std::vector<bool> stays = bound(words);
  std::string result;
  std::string together;
  for (std::size_t i = 0; i < words.size(); ++i) {
    together += replaced(
        escaped(words[i]),
        {{"+-", "\u00b1"}, {"m/s2", "m/s\u00b2"}, {"&gt;=", "\u2265"}, {"&lt;=", "\u2264"}});
    if (stays[i]) {
      together += "\u00a0";
      continue;
    }
    const bool whole =
        together.size() <= longest && (together.starts_with("--") || breaks_in_number(together));
    result += whole ? fmt::format(R"(<span class="number">{}</span>)", together) : together;
    result += i + 1 < words.size() ? " " : "";
    together.clear();
  }
  return result;
}

}  // namespace stillpoint::figures
