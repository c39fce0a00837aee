// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stillpoint::cli {

enum class Command { design, region, simulate };

[[nodiscard]] std::string_view name(Command command) noexcept;

enum class OptionKind { number, integer, text, flag };

/// One option of the program: a flag --name on the command line and a key of a scene file, where
/// '-' and '_' are the same.
struct Option {
  std::string_view name;
  OptionKind kind;
  std::string_view placeholder;  ///< in --help
  std::string_view group;        ///< heading in --help
  std::string_view help;
  bool design;
  bool region;
  bool simulate;

  [[nodiscard]] bool serves(Command command) const;
};

/// Every option of every command, in the order of --help.
[[nodiscard]] std::span<const Option> options();

/// The option of that name, whatever its command; null where there is none.
[[nodiscard]] const Option* find_option(std::string_view name);

/// "; did you mean NAME?" for a name of the list that is one or two slips away, else "".
[[nodiscard]] std::string suggestion(std::string_view wrong);

}  // namespace stillpoint::cli
