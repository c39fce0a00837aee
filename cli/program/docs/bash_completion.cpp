// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"
#include "option_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>

namespace stillpoint::cli {

namespace {

/// The flags of the options for which `holds`, with `separator` between them.
std::string flags(std::string_view separator, const std::function<bool(const Option&)>& holds) {
  std::string list;
  for (const Option& option : options()) {
    if (holds(option)) {
      list += fmt::format("{}--{}", list.empty() ? "" : separator, option.name);
    }
  }
  return list;
}

/// For each option that takes one of some words, these words.
std::string value_cases() {
  std::string cases;
  for (const Option& option : options()) {
    if (!option.traits.values.empty()) {
      cases += fmt::format(
          "    --{}) mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$cur\"); return ;;\n",
          option.name, value_names(option));
    }
  }
  return cases;
}

constexpr std::string_view beginning =
    R"(# Completion of stillpoint for bash, made from its options.

_stillpoint() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command='' words i
  # --option=value comes in three words.
  if [[ $cur == = ]]; then
    cur=''
  elif [[ $prev == = ]] && ((COMP_CWORD > 1)); then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
  COMPREPLY=()
)";

}  // namespace

std::string bash_completion() {
  const auto with_file = [](const Option& option) { return option.takes_file(); };
  const auto with_value = [](const Option& option) {
    return option.kind != OptionKind::flag && !option.takes_file() && option.traits.values.empty();
  };
  std::string script(beginning);
  script += fmt::format(
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      "    case ${{COMP_WORDS[i]}} in\n"
      "      {} | help) command=${{COMP_WORDS[i]}}; break ;;\n"
      "    esac\n"
      "  done\n"
      "  case $prev in\n"
      "{}"
      "    {})\n"
      "      compopt -o filenames 2>/dev/null\n"
      "      mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n"
      "      return ;;\n"
      "    {})\n"
      "      return ;;\n"
      "  esac\n"
      "  case $command in\n",
      command_names(nullptr, " | "), value_cases(), flags(" | ", with_file),
      flags(" | ", with_value));
  for (const CommandHelp& help : all_commands()) {
    const std::string all =
        flags(" ", [&help](const Option& option) { return option.serves(help.command); });
    script += fmt::format("    {}) words='{}{}--help --version' ;;\n", name(help.command),
                          fmt::join(help.words, " "), help.words.empty() ? all + " " : " ");
  }
  script += fmt::format(
      "    help) words='{0}' ;;\n"
      "    *) words='{0} help --help --version' ;;\n"
      "  esac\n"
      "  if [[ -z $command || $command == init || $command == help || $cur == -* ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\")\n"
      "  else\n"
      "    compopt -o filenames 2>/dev/null\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n"
      "  fi\n"
      "}}\n"
      "complete -F _stillpoint stillpoint\n",
      command_names(nullptr, " "));
  return script;
}

}  // namespace stillpoint::cli
