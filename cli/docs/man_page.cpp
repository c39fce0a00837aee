// SPDX-License-Identifier: MIT
#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/texts/embedded.hpp>
#include "generated_docs.hpp"
#include "option_facts.hpp"

namespace stillpoint::cli {

namespace {

/// A line of plain text in roff: no character is a request, a hyphen is a minus.
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

/// Lines that are not filled.
std::string verbatim(std::string_view text) {
  std::string block = ".PP\n.EX\n";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    block += roff(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return block + ".EE\n";
}

std::string synopsis(const CommandHelp& help) {
  return fmt::format(".B stillpoint {}\n[\\fI{}\\fR]{}\n.br\n", name(help.command),
                     help.words.empty() ? "SCENE" : "KIND",
                     help.words.empty() ? " [\\fIOPTION\\fR]..." : "");
}

std::string command_section(const CommandHelp& help) {
  return fmt::format(".SS {}\n{}\n", name(help.command), roff(help.summary)) +
         verbatim(help.examples);
}

std::string more_values(const Option& option) {
  return (option.more_values_in(Command::design).empty()
              ? ""
              : "; LOW:HIGH for a range in design and region") +
         (option.more_values_in(Command::spectrum).empty() ? std::string()
                                                           : "; first:last:count in spectrum");
}

std::string entry(const Option& option) {
  const std::string value =
      option.kind == OptionKind::flag ? "" : fmt::format(" \\fI{}\\fR", roff(option.placeholder));
  return fmt::format(".TP\n\\fB{}\\fR{}\n{} ({}{})\n", roff(fmt::format("--{}", option.name)),
                     value, roff(std::string(option.help) + more_values(option)),
                     command_names(&option, ", "),
                     option.traits.axis.has(Command::sweep) ? "*" : "");
}

/// Every option under the heading of its group, with the commands that have it.
std::string option_entries() {
  std::string_view group;
  return for_options([&group](const Option& option) {
    const bool begins = option.group != group;
    group = option.group;
    return (begins ? fmt::format(".SS {}\n", roff(group)) : "") + entry(option);
  });
}

/// The units of each dimension.
std::string units() {
  std::string entries;
  for (const auto& [what, dimension] :
       {std::pair{"length", Dimension::length}, std::pair{"velocity", Dimension::velocity},
        std::pair{"time", Dimension::time}, std::pair{"frequency", Dimension::frequency},
        std::pair{"mass", Dimension::mass}, std::pair{"stiffness", Dimension::stiffness},
        std::pair{"acceleration", Dimension::acceleration},
        std::pair{"peak of a load", Dimension::gravities}, std::pair{"force", Dimension::force},
        std::pair{"energy", Dimension::energy}}) {
    entries += fmt::format(".TP\n{}\n{}\n", what, records::unit_names(dimension));
  }
  return entries;
}

}  // namespace

std::string man_page() {
  return texts::embedded("shell/man", {{"version", std::string(report::program_version())},
                                       {"synopsis", for_commands(synopsis)},
                                       {"about", roff(program_about())},
                                       {"commands", for_commands(command_section)},
                                       {"options", option_entries()},
                                       {"units", units()}});
}

}  // namespace stillpoint::cli
