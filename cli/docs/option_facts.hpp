// SPDX-License-Identifier: MIT
#pragma once

#include "options/command_line.hpp"

#include <fmt/ranges.h>

namespace stillpoint::cli {

/// One text after another, of every option and of every command.
template <class TextOf>
[[nodiscard]] std::string for_options(TextOf text_of) {
  std::string all;
  for (const Option& option : options()) {
    all += text_of(option);
  }
  return all;
}
template <class TextOf>
[[nodiscard]] std::string for_commands(TextOf text_of) {
  std::string all;
  for (const CommandHelp& help : all_commands()) {
    all += text_of(help);
  }
  return all;
}

/// The names of the commands that the option serves, or of all (null), with `separator` between
/// them.
[[nodiscard]] inline std::string command_names(const Option* option, std::string_view separator) {
  std::string names;
  for (const CommandHelp& help : all_commands()) {
    if (option == nullptr || option->serves(help.command)) {
      names += (names.empty() ? std::string_view() : separator);
      names += name(help.command);
    }
  }
  return names;
}

/// The possible values of the option, separated by blanks; "" if any value is allowed.
[[nodiscard]] inline std::string value_names(const Option& option) {
  return fmt::format("{}", fmt::join(option.values(), " "));
}

/// `text` with `prefix` before every character of `special`.
[[nodiscard]] inline std::string escaped(std::string_view text, std::string_view special,
                                         std::string_view prefix) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) {
      result += prefix;
    }
    result += c;
  }
  return result;
}

}  // namespace stillpoint::cli
