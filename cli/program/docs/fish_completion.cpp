// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"
#include "option_facts.hpp"

#include <fmt/format.h>

namespace stillpoint::cli {

namespace {

std::string quoted(std::string_view text) {
  return "'" + escaped(text, "\\'", "\\") + "'";
}

/// How the value of the option is asked for.
std::string value_switch(const Option& option) {
  if (option.kind == OptionKind::flag) {
    return "";
  }
  if (!option.traits.values.empty()) {
    return fmt::format(" -x -a {}", quoted(value_names(option)));
  }
  return option.takes_file() ? " -r -F" : " -x";
}

}  // namespace

std::string fish_completion() {
  std::string script =
      "# Completion of stillpoint for fish, made from its options.\n"
      "complete -c stillpoint -n __fish_use_subcommand -f\n";
  for (const CommandHelp& help : all_commands()) {
    script += fmt::format("complete -c stillpoint -n __fish_use_subcommand -f -a {} -d {}\n",
                          name(help.command), quoted(help.summary));
    if (!help.words.empty()) {
      script +=
          fmt::format("complete -c stillpoint -n '__fish_seen_subcommand_from {}' -f -a {}\n",
                      name(help.command), quoted(fmt::format("{}", fmt::join(help.words, " "))));
    }
  }
  script += fmt::format(
      "complete -c stillpoint -n __fish_use_subcommand -f -a help -d 'print the options of a "
      "command'\n"
      "complete -c stillpoint -n '__fish_seen_subcommand_from help' -f -a '{}'\n",
      command_names(nullptr, " "));
  for (const Option& option : options()) {
    script += fmt::format(
        "complete -c stillpoint -n '__fish_seen_subcommand_from {}' -l {}{} -d {}\n",
        command_names(&option, " "), option.name, value_switch(option), quoted(option.help));
  }
  return script +
         "complete -c stillpoint -s h -l help -d 'print the options'\n"
         "complete -c stillpoint -l version -d 'print the version'\n";
}

}  // namespace stillpoint::cli
