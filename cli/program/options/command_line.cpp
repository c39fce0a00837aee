// SPDX-License-Identifier: MIT
#include "options/command_line.hpp"

#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/report/terminal.hpp>
#include <stillpoint/report/wrapped.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <filesystem>

namespace stillpoint::cli {

namespace {

/// The text below the options of a command: a file, which ends with a newline.
std::string_view footer(std::string_view text) {
  return text.substr(0, text.size() - 1);
}

/// The first line of its file in data/help is what it is for, the rest its examples.
CommandHelp command_row(Command command, std::vector<std::string_view> words = {}) {
  const std::string_view text = texts::embedded(fmt::format("help/{}.txt", name(command)));
  const std::size_t line = text.find('\n');
  return {command, text.substr(0, line), footer(text.substr(line + 1)), std::move(words)};
}

const std::array command_helps{command_row(Command::design),
                               command_row(Command::region),
                               command_row(Command::simulate),
                               command_row(Command::spectrum),
                               command_row(Command::sweep),
                               command_row(Command::accuracy),
                               command_row(Command::init, {"building", "machine", "equipment"}),
                               command_row(Command::explore, {"open", "path"})};

/// What CLI11 collects for one subcommand: strings, which are converted once the command is known.
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
            : app.add_option(flag, collected.texts[option.name], option.help_in(help.command))
                  ->type_name(std::string(option.kind_in(help.command) == OptionKind::axis
                                              ? "AXIS"
                                              : option.placeholder))
                  ->expected(1)
                  ->allow_extra_args(false)
                  ->take_all();
    added->group(std::string(option.group));
  }
  app.footer(std::string(help.examples));
  constexpr std::size_t longest = 29;  // "  --excitation-frequency AXIS", then two blanks
  app.get_formatter()->column_width(longest + 2);
  app.allow_extras();
}

/// "merge OUT PART..." behind "sweep".
void add_merge(CLI::App& sweep, MergeFiles& files) {
  CLI::App& merge = *sweep.add_subcommand("merge", "join the parts of a sweep, see --part");
  merge.set_help_flag("-h,--help", "print this text");
  merge.fallthrough();
  merge.add_option("OUT", files.output, "the file of the whole sweep")->type_name("");
  merge.add_option("PART", files.parts, "the file of each part, in any order")->type_name("");
}

/// With the files behind a "--".
MergeFiles whole_merge(MergeFiles files, const std::vector<std::string>& operands) {
  files.parts.insert(files.parts.end(), operands.begin(), operands.end());
  if (files.output.empty() && !files.parts.empty()) {
    files.output = files.parts.front();
    files.parts.erase(files.parts.begin());
  }
  if (files.parts.empty()) {
    throw UsageError("merge needs the file to write and the file of each part: merge OUT PART...");
  }
  return files;
}

/// The second word of "--velocity 400 mm/s".
void refuse_unit(const std::string& word) {
  if (records::is_unit(word) && !std::filesystem::exists(word)) {
    throw UsageError(fmt::format(
        "{0}: a unit must follow its number without a space: 1{0}, or \"1 {0}\" in quotes", word));
  }
}

[[noreturn]] void refuse_second(const std::string& word, Command command) {
  throw UsageError(fmt::format(
      "{}: unexpected, only one {} can be given", records::shortened(word, records::longest_word),
      command == Command::init || command == Command::explore ? "word" : "scene"));
}

void refuse_extras(const CLI::App& app, Command command) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) {
    return;
  }
  const std::string first = records::shortened(extras.front(), records::longest_word);
  refuse_unit(first);
  if (!first.starts_with("-")) {
    refuse_second(first, command);
  }
  std::string_view bare = first;
  bare.remove_prefix(std::min(bare.find_first_not_of('-'), bare.size()));
  bare = bare.substr(0, bare.find('='));
  const Option* known = find_option(bare);
  if (known == nullptr) {
    throw UsageError(fmt::format("{}: unknown option{}", first, suggestion(bare, command, "--")));
  }
  if (known->serves(command)) {
    throw UsageError(fmt::format("{}: an option begins with two dashes: --{}", first, bare));
  }
  std::vector<std::string_view> takers;
  for (const CommandHelp& help : command_helps) {
    if (known->serves(help.command)) {
      takers.push_back(name(help.command));
    }
  }
  throw UsageError(fmt::format(
      "{}: is not an option of {}, only of {}{}{}", first, app.get_name(), fmt::join(takers, ", "),
      known->traits.instead.words.empty() ? "" : "; ", known->traits.instead.words));
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
      settings.set_text(option, fmt::format("{}", fmt::join(texts, "\n")), command);
    }
  }
  return settings;
}

/// The parts contain the task.
void refuse_beside_merge(const Invocation& invocation, const CLI::App& app) {
  if (app.get_option("scene")->count() > 0 || !invocation.flags.entries().empty()) {
    throw UsageError("sweep merge: takes OUT and the files of the parts, no scene and no options");
  }
}

void require_command(const std::optional<std::string>& given) {
  const std::vector<std::string_view> commands = names<Command>();
  std::vector<std::string_view> known = commands;
  known.emplace_back("help");
  const std::string word = given.value_or("");
  if (word.starts_with('-')) {
    throw UsageError(fmt::format("{}: an option comes after its command: {} (stillpoint --help)",
                                 records::shortened(word, records::longest_word),
                                 listed(commands)));
  }
  if (std::ranges::find(commands, word) == commands.end()) {
    throw UsageError(fmt::format(
        "{}: must be {} (stillpoint --help){}",
        given
            ? "command " + (word.empty() ? "\"\"" : records::shortened(word, records::longest_word))
            : "no command",
        listed(commands),
        word.ends_with(".json") ? fmt::format("; did you mean design {}?",
                                              records::shortened(word, records::longest_word))
                                : suggestion(word, known)));
  }
}

/// "help" with a command is that command's --help; with itself, the program's.
std::vector<std::string> without_help_command(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    if (words.size() > 1 && !words[1].starts_with('-')) {
      throw UsageError(fmt::format("help {}: one command at a time", words.front()));
    }
    if (words == std::vector<std::string>{"help"}) {
      words.clear();
    }
    if (!words.empty() && !words[0].starts_with('-')) {
      require_command(words[0]);
    }
    words.emplace_back("--help");
  }
  return words;
}

/// The words behind "--", which is removed with them. They name files, even if they begin with a
/// dash.
std::vector<std::string> take_operands(std::vector<std::string>& words) {
  const auto mark = std::ranges::find(words, "--");
  if (mark == words.begin() || mark == words.end()) {  // require_command refuses the first word
    return {};
  }
  std::vector<std::string> operands(mark + 1, words.end());
  words.erase(mark, words.end());
  return operands;
}

/// What CLI11 says of a missing value or a value of a flag as a sentence; anything else as it is.
std::string in_words(const std::string& message) {
  if (constexpr std::string_view flag = "Could not convert: "; message.starts_with(flag)) {
    return message.substr(flag.size()) + ": this option takes no value";
  }
  constexpr std::string_view wants = ": 1 required ";
  constexpr std::string_view ends = " missing";
  const std::size_t at = message.find(wants);
  if (at == std::string::npos || !message.ends_with(ends)) {
    return message;
  }
  const std::size_t from = at + wants.size();
  return fmt::format("{} needs a value: {} {}", message.substr(0, at), message.substr(0, at),
                     message.substr(from, message.size() - ends.size() - from));
}

}  // namespace

std::span<const CommandHelp> all_commands() {
  return command_helps;
}

std::string_view program_about() {
  return "Designs friction dampers for a mass on a spring. A hit gives the mass the velocity v0. "
         "Constant friction f and a notch with the point friction delta must stop it where it was "
         "at rest, and it must never move farther than beta.";
}

std::string short_help() {
  std::string commands;
  for (const CommandHelp& help : command_helps) {
    commands += fmt::format("  {:<10}{}\n", name(help.command), help.summary);
  }
  return report::wrapped(texts::embedded("help/short.txt", {{"commands", commands}}),
                         report::terminal_width());
}

Invocation parse_command_line(int argc, const char* const* argv) {
  CLI::App app{std::string(program_about()), "stillpoint"};
  app.set_help_flag("-h,--help", "print this text");
  app.set_version_flag("--version", report::version_line())->description("print the version");
  app.allow_extras();
  app.footer(std::string(footer(texts::embedded("help/stillpoint.txt"))));
  std::vector<std::string> words = without_help_command(argc, argv);
  std::vector<std::string> operands = take_operands(words);
  std::ranges::reverse(words);  // as CLI11 takes them
  std::map<Command, Collected> collected;
  MergeFiles merge;
  for (const CommandHelp& help : command_helps) {
    CLI::App& command =
        *app.add_subcommand(std::string(name(help.command)), std::string(help.summary));
    // Setting up the options of all commands would take longer than most answers do.
    if (std::ranges::find(words, command.get_name()) != words.end()) {
      add_options(command, help, collected[help.command]);
      if (help.command == Command::sweep) {
        add_merge(command, merge);
      }
    }
  }
  app.add_subcommand("help", "print the options of a command");
  Invocation invocation;
  try {
    app.parse(words);
  } catch (const CLI::Success& asked) {
    invocation.reply = dynamic_cast<const CLI::CallForVersion*>(&asked) != nullptr
                           ? fmt::format("{}\n", asked.what())
                           : report::wrapped(app.help(), report::terminal_width());
    return invocation;
  } catch (const CLI::ParseError& error) {
    throw UsageError(records::shortened(in_words(error.what()), records::longest_path));
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
  invocation.command = *parse<Command>(chosen.get_name());
  const Collected& given = collected.at(invocation.command);
  refuse_extras(chosen, invocation.command);
  invocation.flags = from_flags(chosen, given, invocation.command);
  if (!chosen.get_subcommands().empty()) {
    refuse_beside_merge(invocation, chosen);
    invocation.merge = whole_merge(std::move(merge), operands);
    return invocation;
  }
  if (chosen.get_option("scene")->count() > 0) {
    refuse_unit(given.scene);
    operands.insert(operands.begin(), given.scene);
  }
  if (operands.size() > 1) {
    refuse_second(operands[1], invocation.command);
  }
  if (!operands.empty()) {
    invocation.scene = operands[0];
  }
  const auto& known =
      std::ranges::find(command_helps, invocation.command, &CommandHelp::command)->words;
  if (!known.empty()) {
    const std::string word = invocation.scene.value_or(std::string(known.front()));
    if (std::ranges::find(known, word) == known.end()) {
      throw InputError(chosen.get_name(), word, must_be(word, known));
    }
    invocation.scene = word;
  }
  return invocation;
}

}  // namespace stillpoint::cli
