// SPDX-License-Identifier: MIT
#include <stillpoint/report/version.hpp>
#include "generated_docs.hpp"
#include "option_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace stillpoint::cli {

namespace {

/// A line of plain text as roff has it: no character is a request, a hyphen is a minus.
std::string roff(std::string_view text) {
  static const std::map<char, std::string_view> escapes{
      {'\\', "\\e"}, {'-', "\\-"}, {'\'', "\\(aq"}, {'^', "\\(ha"}, {'~', "\\(ti"}};
  std::string result;
  for (const char c : text) {
    const auto found = escapes.find(c);
    result += found == escapes.end() ? std::string_view(&c, 1) : found->second;
  }
  return result.starts_with('.') ? "\\&" + result : result;
}

/// Lines that stay as they are.
std::string verbatim(std::string_view text) {
  std::string block = ".PP\n.EX\n";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    block += roff(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return block + ".EE\n";
}

std::string synopsis() {
  std::string page = ".SH SYNOPSIS\n";
  for (const CommandHelp& help : all_commands()) {
    page += fmt::format(".B stillpoint {}\n[\\fI{}\\fR]{}\n.br\n", name(help.command),
                        help.words.empty() ? "SCENE" : "KIND",
                        help.words.empty() ? " [\\fIOPTION\\fR]..." : "");
  }
  page += ".B stillpoint help\n[\\fICOMMAND\\fR]\n.br\n";
  return page + ".B stillpoint \\-\\-help\n|\n.B \\-\\-version\n";
}

std::string commands() {
  std::string page = ".SH COMMANDS\n";
  for (const CommandHelp& help : all_commands()) {
    page += fmt::format(".SS {}\n{}\n", name(help.command), roff(help.summary));
    page += verbatim(help.examples);
  }
  return page;
}

std::string entry(const Option& option) {
  const std::string value =
      option.kind == OptionKind::flag ? "" : fmt::format(" \\fI{}\\fR", roff(option.placeholder));
  return fmt::format(".TP\n\\fB{}\\fR{}\n{} ({}{})\n", roff(fmt::format("--{}", option.name)),
                     value, roff(option.help), command_names(&option, ", "),
                     option.traits.sweeps ? "*" : "");
}

/// Every option under the heading of its group, with the commands that have it.
std::string option_entries() {
  std::string page =
      ".SH OPTIONS\nThe commands that have an option stand in brackets;\n.B sweep*\n"
      "takes an axis.\n";
  std::string_view group;
  for (const Option& option : options()) {
    if (option.group != group) {
      group = option.group;
      page += fmt::format(".SS {}\n", roff(group));
    }
    page += entry(option);
  }
  return page +
         ".SS Of every command\n.TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nprint the options\n"
         ".TP\n\\fB\\-\\-version\\fR\n"
         "print the version, that of NLopt and the build type\n";
}

constexpr std::string_view scenes =
    ".SH SCENES\n"
    "A scene is a JSON file; its keys are the names of the options, with _ or \\-.\n"
    "Comments, // and /* */, are allowed. A flag overrides a key. The scene \\fB\\-\\fR is "
    "standard input.\n"
    "The JSON Schema of scenes and those of the reports are installed in\n"
    ".IR share/stillpoint/schemas .\n";

/// The units of each dimension.
std::string units() {
  std::string page =
      ".SH UNITS\nA physical value may carry its unit: 150mm, 2.8s, 1200t; in a scene as a text. A "
      "bare "
      "number is in the first unit of its line.\n";
  for (const auto& [what, dimension] :
       {std::pair{"length", Dimension::length}, std::pair{"velocity", Dimension::velocity},
        std::pair{"time", Dimension::time}, std::pair{"frequency", Dimension::frequency},
        std::pair{"mass", Dimension::mass}, std::pair{"stiffness", Dimension::stiffness},
        std::pair{"acceleration", Dimension::acceleration},
        std::pair{"peak of a load", Dimension::gravities}}) {
    page += fmt::format(".TP\n{}\n{}\n", what, records::unit_names(dimension));
  }
  return page;
}

constexpr std::string_view exit_status =
    ".SH EXIT STATUS\n"
    ".TP\n0\ndone\n"
    ".TP\n2\nwrong input: standard error names the field, the value and the bound; nothing is "
    "written\n"
    ".TP\n3\nno admissible design: the report says why, and the least change of each input that "
    "would allow one\n"
    ".TP\n4\nthe cross\\-check disagrees; the report is written\n"
    ".TP\n130\ninterrupted; the rows of a sweep so far are kept\n";

constexpr std::string_view environment =
    ".SH ENVIRONMENT\n"
    ".TP\n.B NO_COLOR\nif it is set, the reports have no colours\n"
    ".TP\n.B COLUMNS\nhow wide help may be\n"
    ".TP\n.B BROWSER\nwhat opens the page of \\-\\-open\n";

}  // namespace

std::string man_page() {
  return fmt::format(
             ".TH STILLPOINT 1 \"\" \"stillpoint {0}\" \"User Commands\"\n"
             ".SH NAME\nstillpoint \\- design friction dampers\n",
             report::program_version()) +
         synopsis() + ".SH DESCRIPTION\n" + roff(program_about()) + "\n" + commands() +
         option_entries() + std::string(scenes) + units() + std::string(exit_status) +
         std::string(environment);
}

}  // namespace stillpoint::cli
