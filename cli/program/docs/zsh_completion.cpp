// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"
#include "option_facts.hpp"

#include <fmt/format.h>

namespace stillpoint::cli {

namespace {

/// The text of a description in [brackets], or of a message between colons, within single quotes: a
/// quote ends them, stands escaped and begins them anew.
std::string inner(std::string_view text) {
  return escaped(escaped(text, "[]:\\", "\\"), "'", "'\\'");
}

std::string argument(const Option& option) {
  if (option.kind == OptionKind::flag) {
    return fmt::format("'--{}[{}]'", option.name, inner(option.help));
  }
  const std::string action = !option.traits.values.empty()
                                 ? fmt::format("({})", value_names(option))
                             : option.takes_file() ? "_files"
                                                   : "";
  return fmt::format("'--{}=[{}]:{}:{}'", option.name, inner(option.help),
                     inner(option.placeholder), action);
}

std::string arguments(Command command) {
  std::string list;
  for (const Option& option : options()) {
    if (option.serves(command)) {
      list += fmt::format("        {} \\\n", argument(option));
    }
  }
  return list;
}

}  // namespace

std::string zsh_completion() {
  std::string script =
      "#compdef stillpoint\n"
      "# Completion of stillpoint for zsh, made from its options.\n\n"
      "_stillpoint() {\n"
      "  local -a commands\n"
      "  commands=(\n";
  for (const CommandHelp& help : all_commands()) {
    script += fmt::format("    '{}:{}'\n", name(help.command), inner(help.summary));
  }
  script +=
      "    'help:print the options of a command'\n"
      "  )\n"
      "  if ((CURRENT == 2)); then\n"
      "    _describe -t commands command commands\n"
      "    _arguments '(- *)'{-h,--help}'[print the help]' '(- *)--version[print the version]'\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  ((CURRENT--))\n"
      "  case $command in\n";
  for (const CommandHelp& help : all_commands()) {
    script += fmt::format(
        "    {})\n"
        "      _arguments \\\n"
        "{}"
        "        '(- *)'{{-h,--help}}'[print the options]' \\\n"
        "        '(- *)--version[print the version]' \\\n"
        "        '1:{}'\n"
        "      ;;\n",
        name(help.command), arguments(help.command),
        help.words.empty() ? "scene:_files" : fmt::format("kind:({})", fmt::join(help.words, " ")));
  }
  return script + "    help) _values command " + command_names(nullptr, " ") +
         " ;;\n"
         "  esac\n"
         "}\n\n"
         "_stillpoint \"$@\"\n";
}

}  // namespace stillpoint::cli
