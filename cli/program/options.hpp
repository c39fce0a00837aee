// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stillpoint::cli {

enum class Command { design, region, simulate, sweep, accuracy };

[[nodiscard]] std::string_view name(Command command) noexcept;

/// Some of the commands: design | sweep.
class CommandSet {
 public:
  // One command is a set of one. NOLINTNEXTLINE(google-explicit-constructor)
  constexpr CommandSet(Command one) : bits_(1U << static_cast<unsigned>(one)) {}

  [[nodiscard]] constexpr bool has(Command command) const {
    return (bits_ & CommandSet(command).bits_) != 0;
  }
  friend constexpr CommandSet operator|(CommandSet a, CommandSet b) {
    a.bits_ |= b.bits_;
    return a;
  }

 private:
  unsigned bits_;
};

constexpr CommandSet operator|(Command a, Command b) {
  return CommandSet(a) | CommandSet(b);
}

/// An axis is one number or many, see Axis.
enum class OptionKind { number, integer, text, flag, axis };

/// One option of the program: a flag --name on the command line and a key of a scene file, where
/// '-' and '_' are the same.
struct Option {
  std::string_view name;
  OptionKind kind;
  std::string_view placeholder;  ///< in --help
  std::string_view group;        ///< heading in --help
  std::string_view help;
  CommandSet commands;
  bool sweeps{false};  ///< a number, but in a sweep an axis

  [[nodiscard]] constexpr bool serves(Command command) const { return commands.has(command); }
  [[nodiscard]] constexpr OptionKind kind_in(Command command) const {
    return sweeps && command == Command::sweep ? OptionKind::axis : kind;
  }
};

/// Every option of every command, in the order of --help.
[[nodiscard]] std::span<const Option> options();

/// The option of that name, whatever its command; null where there is none.
[[nodiscard]] const Option* find_option(std::string_view name);

/// "; did you mean NAME?" for a name of the list that is one or two slips away, else "".
[[nodiscard]] std::string suggestion(std::string_view wrong);

}  // namespace stillpoint::cli
