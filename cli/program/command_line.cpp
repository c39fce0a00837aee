// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <stillpoint/records/text.hpp>
#include <stillpoint/report/version.hpp>
#include "starter_scenes.hpp"
#include "terminal_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

namespace {

const std::array command_helps{
    CommandHelp{
        Command::design, "design a damper that stops at x = 0 on the first return",
        "Examples:\n"
        "  stillpoint design --velocity 400mm/s --period 2.8s --max-displacement 150mm --mass "
        "1200t\n"
        "  stillpoint design --pulse half-sine --k 0.5g --pulse-duration 70ms --period 2.8s "
        "--max-displacement 100mm\n"
        "  stillpoint design data/scenes/isolator.json --objective time --tolerance 0.1 --open\n"
        "  stillpoint design --v0 1 --p 1 --beta 0.8\n"
        "  stillpoint design scene.json --json | jq .design\n"
        "Exit codes: 0 done, 2 wrong input, 3 no admissible design, 4 cross-check failed."},
    CommandHelp{Command::region, "the admissible region of f and delta, without a search",
                "Examples:\n"
                "  stillpoint region --velocity 400mm/s --period 2.8s --max-displacement 150mm\n"
                "  stillpoint region --v0 1 --p 1 --beta 0.8 --f 0.3 --delta 0.4\n"
                "Exit codes: 0 done, 2 wrong input, 3 the region is empty."},
    CommandHelp{Command::simulate, "one motion, free or forced: metrics, half-cycles, trajectory",
                "Examples:\n"
                "  stillpoint simulate --velocity 400mm/s --period 3s --f 0.02 --delta-m 10mm "
                "--trajectory motion.csv\n"
                "  stillpoint simulate --natural-frequency 0.36Hz --f 0.02 --delta-m 1mm "
                "--excitation harmonic --k 0.1g --excitation-frequency 0.5Hz --end-time 40s\n"
                "  stillpoint simulate --period 2.8s --f 0.02 --delta-m 1mm --record "
                "data/records/near_fault_pulse.txt\n"
                "  stillpoint simulate --v0 1 --p 1 --f 0.02 --delta 0.02\n"
                "  stillpoint simulate --v0 0.5 --p 1 --f 0.18 --delta 0 --excitation harmonic --k "
                "0.2 --lambda 0.35 --t-end 200\n"
                "Exit codes: 0 done, 2 wrong input, 130 interrupted."},
    CommandHelp{
        Command::spectrum, "one damper under records over the period, beside f alone",
        "PERIOD is first:last:count, first:last:count:log, or numbers a,b,c. f and delta are "
        "the same at every period.\n"
        "Examples:\n"
        "  stillpoint spectrum --record data/records/near_fault_pulse.txt --period 1s:4s:60 "
        "--f 0.05 --delta-m 50mm --hold 0.1 --html page.html\n"
        "  stillpoint spectrum --records-list suite.csv --period 0.5s:5s:200 --f 0.05 "
        "--delta-m 10mm --table spectrum.npy\n"
        "Exit codes: 0 done, 2 wrong input, 130 interrupted."},
    CommandHelp{
        Command::sweep, "many motions, or many designs: a grid or a list, as CSV or .npy",
        "AXIS is a number, first:last:count, first:last:count:log, or numbers a,b,c. The "
        "entries are all combinations. With --beta a damper is designed for each entry; "
        "without it each motion is simulated.\n"
        "Examples:\n"
        "  stillpoint sweep --v0 1 --p 1 --f 0.001:0.35:50 --delta 0:0.5:50\n"
        "  stillpoint sweep --v0 1 --p 1 --f 1e-3:0.3:200:log --delta 0.01 --times --output s.npy\n"
        "  stillpoint sweep --v0 1 --p 1 --beta 0.75:0.95:5 --tolerance 0.05\n"
        "  stillpoint sweep --p 1 --f 0.05:0.2:16 --delta 0 --excitation harmonic --k 0.2 --lambda "
        "0.35 --t-end 200\n"
        "  stillpoint sweep --v0 1 --p 1 --list dampers.csv --output s.csv --resume\n"
        "Exit codes: 0 done, 2 wrong input, 130 interrupted; continue with --resume."},
    CommandHelp{Command::accuracy, "time and error of each method on one motion, against 50 digits",
                "Examples:\n"
                "  stillpoint accuracy --v0 1 --p 1 --f 0.02 --delta 0.02\n"
                "  stillpoint accuracy --v0 0.5 --p 1 --f 0.18 --delta 0 --excitation harmonic --k "
                "0.2 --lambda 0.35 --t-end 200\n"
                "Exit codes: 0 done, 2 wrong input."},
    CommandHelp{Command::init, "print a commented scene to start from",
                "Examples:\n"
                "  stillpoint init > scene.json\n"
                "  stillpoint init machine | stillpoint design -\n"
                "Exit codes: 0 done, 2 wrong input.",
                starter_names()},
};

constexpr std::string_view about =
    "Designs friction dampers. A linear oscillator with constant friction f and point friction "
    "delta at x = 0 starts with velocity v0; it must stop at x = 0 and never move further than "
    "beta.";

constexpr std::string_view epilogue =
    "Examples:\n"
    "  stillpoint design --velocity 400mm/s --period 2.8s --max-displacement 150mm\n"
    "  stillpoint init building > scene.json\n"
    "  stillpoint design scene.json --open\n\n"
    "A scene is a JSON file, which may have comments; its keys are the names of the options, and a "
    "flag overrides it. \"-\" reads it from standard input. \"stillpoint help COMMAND\" lists the "
    "options of a command.";

/// What CLI11 collects for one subcommand; texts, which are converted once the command is known.
struct Collected {
  std::string scene;
  std::map<std::string_view, std::vector<std::string>> texts;
  std::map<std::string_view, bool> flags;
};

void add_options(CLI::App& app, const CommandHelp& help, Collected& collected) {
  app.set_help_flag("-h,--help", "print this text");
  app.add_flag_callback(
         "--version", [] { throw CLI::CallForVersion(report::version_line(), 0); },
         "print the version")
      ->configurable(false);
  app.add_option("scene", collected.scene,
                 help.words.empty()
                     ? "scene file in JSON, or - for standard input"
                     : listed(help.words) + "; default " + std::string(help.words.front()))
      ->type_name("");
  for (const Option& option : options()) {
    if (!option.serves(help.command)) {
      continue;
    }
    const std::string flag = fmt::format("--{}", option.name);
    CLI::Option* added =
        option.kind == OptionKind::flag
            ? app.add_flag(flag, collected.flags[option.name], std::string(option.help))
            : app.add_option(flag, collected.texts[option.name], std::string(option.help))
                  ->type_name(std::string(option.kind_in(help.command) == OptionKind::axis
                                              ? "AXIS"
                                              : option.placeholder))
                  ->expected(1)
                  ->allow_extra_args(false)
                  ->take_all();
    added->group(std::string(option.group));
  }
  app.footer(std::string(help.examples));
  app.allow_extras();
}

void refuse_extras(const CLI::App& app, Command command) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) {
    return;
  }
  const std::string first = records::shortened(extras.front(), records::longest_word);
  if (!first.starts_with("-")) {
    throw UsageError(fmt::format("{}: unexpected, only one scene can be given", first));
  }
  std::string_view bare = first;
  bare.remove_prefix(std::min(bare.find_first_not_of('-'), bare.size()));
  bare = bare.substr(0, bare.find('='));
  const Option* known = find_option(bare);
  throw UsageError(known != nullptr
                       ? fmt::format("{}: is not an option of {}", first, app.get_name())
                       : fmt::format("{}: unknown option{}", first, suggestion(bare, command)));
}

void set_typed(Settings& settings, const Option& option, const std::string& text, Command command) {
  switch (option.kind_in(command)) {
    case OptionKind::axis:
      return settings.set(option, axis_value(option, text));
    case OptionKind::number:
      return option.takes_range_in(command) ? settings.set_number_or_range(option, text)
                                            : settings.set_number(option, text);
    case OptionKind::integer:
      return settings.set(option, parse_integer(option.name, text));
    case OptionKind::text:
    case OptionKind::flag:
      break;
  }
  settings.set(option, text);
}

Settings from_flags(const CLI::App& app, const Collected& collected, Command command) {
  Settings settings;
  for (const Option& option : options()) {
    const CLI::Option* given = app.get_option_no_throw(fmt::format("--{}", option.name));
    if (given == nullptr || given->count() == 0) {
      continue;
    }
    if (given->count() > 1 && !option.repeats_in(command)) {
      throw UsageError(fmt::format("--{} is given {} times: an option can be given only once",
                                   option.name, given->count()));
    }
    if (option.kind == OptionKind::flag) {
      settings.set(option, collected.flags.at(option.name));
    } else {
      const std::vector<std::string>& texts = collected.texts.at(option.name);
      set_typed(settings, option, fmt::format("{}", fmt::join(texts, "\n")), command);
    }
  }
  return settings;
}

std::vector<std::string_view> command_names() {
  std::vector<std::string_view> names;
  names.reserve(command_helps.size());
  for (const CommandHelp& help : command_helps) {
    names.push_back(name(help.command));
  }
  return names;
}

void require_command(const std::optional<std::string>& given) {
  const std::vector<std::string_view> names = command_names();
  const std::string word = given.value_or("");
  if (std::ranges::find(names, word) == names.end()) {
    throw UsageError(fmt::format(
        "{}: must be {} (stillpoint --help){}",
        given ? "command " + records::shortened(word, records::longest_word) : "no command",
        listed(names), suggestion(word, names)));
  }
}

/// "help" is for people alone: with a command it is that command's --help.
std::vector<std::string> without_help_command(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    if (words.size() > 1 && !words[1].starts_with('-')) {
      throw UsageError(fmt::format("help {}: one command at a time", words.front()));
    }
    if (!words.empty() && !words[0].starts_with('-')) {
      require_command(words[0]);
    }
    words.emplace_back("--help");
  }
  std::ranges::reverse(words);  // as CLI11 takes them
  return words;
}

}  // namespace

std::span<const CommandHelp> all_commands() {
  return command_helps;
}

std::string_view program_about() {
  return about;
}

std::string short_help() {
  std::string text =
      "stillpoint designs friction dampers that stop a mass after a hit, centred and within its "
      "stroke.\n\nCommands:\n";
  for (const CommandHelp& help : command_helps) {
    text += fmt::format("  {:<10}{}\n", name(help.command), help.summary);
  }
  text +=
      "\nExamples:\n"
      "  stillpoint design --velocity 400mm/s --period 2.8s --max-displacement 150mm\n"
      "  stillpoint init building > scene.json\n\n"
      "\"stillpoint help COMMAND\" lists the options of a command.\n";
  return wrapped(text, help_width());
}

Invocation parse_command_line(int argc, const char* const* argv) {
  CLI::App app{std::string(about), "stillpoint"};
  app.set_help_flag("-h,--help", "print this text");
  app.set_version_flag("--version", report::version_line())->description("print the version");
  app.allow_extras();
  app.footer(std::string(epilogue));
  std::array<Collected, command_helps.size()> collected;
  for (std::size_t i = 0; i < command_helps.size(); ++i) {
    const CommandHelp& help = command_helps[i];
    add_options(*app.add_subcommand(std::string(name(help.command)), std::string(help.summary)),
                help, collected[i]);
  }
  app.add_subcommand("help", "print the options of a command");
  Invocation invocation;
  std::vector<std::string> words = without_help_command(argc, argv);
  try {
    app.parse(words);
  } catch (const CLI::Success& asked) {
    invocation.reply = dynamic_cast<const CLI::CallForVersion*>(&asked) != nullptr
                           ? fmt::format("{}\n", asked.what())
                           : wrapped(app.help(), help_width());
    return invocation;
  } catch (const CLI::ParseError& error) {
    throw UsageError(records::shortened(error.what(), records::longest_path));
  }
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (parsed.empty()) {
    const std::vector<std::string> extras = app.remaining();
    require_command(extras.empty() ? std::nullopt : std::optional(extras.front()));
  }
  if (parsed.size() > 1) {
    throw UsageError(fmt::format("{} and {}: one command at a time", parsed[0]->get_name(),
                                 parsed[1]->get_name()));
  }
  const CLI::App& chosen = *parsed.front();
  const auto index = static_cast<std::size_t>(
      std::ranges::find(command_helps, chosen.get_name(),
                        [](const CommandHelp& help) { return name(help.command); }) -
      command_helps.begin());
  invocation.command = command_helps[index].command;
  refuse_extras(chosen, invocation.command);
  invocation.flags = from_flags(chosen, collected[index], invocation.command);
  if (chosen.get_option("scene")->count() > 0) {
    invocation.scene = collected[index].scene;
  }
  return invocation;
}

}  // namespace stillpoint::cli
