// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"
#include "option_facts.hpp"

#include <stillpoint/texts/embedded.hpp>

namespace stillpoint::cli {

namespace {

std::string commands() {
  return command_names(nullptr, " ");
}

/// The flags of the options for which `holds`, with `separator` between them.
template <class Holds>
std::string flags(std::string_view separator, Holds holds) {
  const std::string list = for_options([&](const Option& option) {
    return holds(option) ? fmt::format("{}--{}", separator, option.name) : "";
  });
  return list.empty() ? "" : list.substr(separator.size());
}

/// The text of a description in [brackets], or of a message between colons, within single quotes: a
/// quote ends them, is escaped, and begins them anew.
std::string in_zsh(std::string_view text) {
  return escaped(escaped(text, "[]:\\", "\\"), "'", "'\\'");
}

std::string zsh_argument(const Option& option) {
  const std::string action = !option.values().empty() ? fmt::format("({})", value_names(option))
                             : option.takes_file()    ? "_files"
                                                      : "";
  return option.kind == OptionKind::flag
             ? fmt::format("        '--{}[{}]' \\\n", option.name, in_zsh(option.help))
             : fmt::format("        '--{}=[{}]:{}:{}' \\\n", option.name, in_zsh(option.help),
                           in_zsh(option.placeholder), action);
}

std::string zsh_case(const CommandHelp& help) {
  return fmt::format(
      "    {})\n"
      "      _arguments \\\n"
      "{}        '(- *)'{{-h,--help}}'[print the options]' \\\n"
      "        '(- *)--version[print the version]' \\\n"
      "        '1:{}'\n"
      "      ;;\n",
      name(help.command), for_options([&](const Option& option) {
        return option.serves(help.command) ? zsh_argument(option) : "";
      }),
      help.words.empty() ? "scene:_files" : fmt::format("kind:({})", fmt::join(help.words, " ")));
}

std::string in_fish(std::string_view text) {
  return "'" + escaped(text, "\\'", "\\") + "'";
}

std::string fish_subcommand(const CommandHelp& help) {
  std::string lines =
      fmt::format("complete -c stillpoint -n __fish_use_subcommand -f -a {} -d {}\n",
                  name(help.command), in_fish(help.summary));
  if (!help.words.empty()) {
    lines +=
        fmt::format("complete -c stillpoint -n '__fish_seen_subcommand_from {}' -f -a {}\n",
                    name(help.command), in_fish(fmt::format("{}", fmt::join(help.words, " "))));
  }
  return lines;
}

std::string fish_option(const Option& option) {
  const std::string value = option.kind == OptionKind::flag ? ""
                            : !option.values().empty()
                                ? fmt::format(" -x -a {}", in_fish(value_names(option)))
                            : option.takes_file() ? " -r -F"
                                                  : " -x";
  return fmt::format("complete -c stillpoint -n '__fish_seen_subcommand_from {}' -l {}{} -d {}\n",
                     command_names(&option, " "), option.name, value, in_fish(option.help));
}

}  // namespace

std::string bash_completion() {
  const auto values = [](const Option& option) {
    return option.values().empty()
               ? ""
               : fmt::format(
                     "    --{}) mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$cur\"); return ;;\n",
                     option.name, value_names(option));
  };
  const auto words = [](const CommandHelp& help) {
    const std::string all = flags(" ", [&](const Option& o) { return o.serves(help.command); });
    return fmt::format("    {}) words='{} --help --version' ;;\n", name(help.command),
                       help.words.empty() ? all : fmt::format("{}", fmt::join(help.words, " ")));
  };
  return texts::embedded(
      "shell/bash",
      {{"commands", commands()},
       {"command_cases", command_names(nullptr, " | ")},
       {"value_cases", for_options(values)},
       {"with_file", flags(" | ", [](const Option& option) { return option.takes_file(); })},
       {"with_value", flags(" | ",
                            [](const Option& option) {
                              return option.kind != OptionKind::flag && !option.takes_file() &&
                                     option.values().empty();
                            })},
       {"option_cases", for_commands(words)}});
}

std::string zsh_completion() {
  const auto summary = [](const CommandHelp& help) {
    return fmt::format("    '{}:{}'\n", name(help.command), in_zsh(help.summary));
  };
  return texts::embedded("shell/zsh", {{"commands", commands()},
                                       {"summaries", for_commands(summary)},
                                       {"cases", for_commands(zsh_case)}});
}

std::string fish_completion() {
  return texts::embedded("shell/fish", {{"commands", commands()},
                                        {"subcommands", for_commands(fish_subcommand)},
                                        {"options", for_options(fish_option)}});
}

}  // namespace stillpoint::cli
