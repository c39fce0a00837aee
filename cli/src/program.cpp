// SPDX-License-Identifier: MIT
#include "program.hpp"

#include "commands.hpp"
#include "options.hpp"
#include "scene.hpp"
#include "version.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

namespace stillpoint::cli {

namespace {

struct CommandLine {
  Command command;
  std::string_view summary;
  std::string_view examples;
  ExitCode (*run)(const Settings&, Output&);
};

constexpr std::array command_lines{
    CommandLine{Command::design, "design a damper that stops at x = 0 on the first return",
                "Examples:\n"
                "  stillpoint design --v0 1 --p 1 --beta 0.8\n"
                "  stillpoint design --velocity 0.4 --period 3 --max-displacement 0.16 --mass 2e5\n"
                "  stillpoint design data/scenes/isolator.json --objective time --tolerance 0.1\n"
                "  stillpoint design scene.json --json | jq .design\n"
                "Exit codes: 0 done, 2 wrong input, 3 no admissible design, 4 cross-check failed.",
                run_design},
    CommandLine{Command::region, "the admissible region of f and delta, without a search",
                "Examples:\n"
                "  stillpoint region --v0 1 --p 1 --beta 0.8\n"
                "  stillpoint region --v0 1 --p 1 --beta 0.8 --f 0.3 --delta 0.4\n"
                "Exit codes: 0 done, 2 wrong input, 3 the region is empty.",
                run_region},
    CommandLine{Command::simulate, "one free motion: metrics, half-cycles, trajectory",
                "Examples:\n"
                "  stillpoint simulate --v0 1 --p 1 --f 0.02 --delta 0.02\n"
                "  stillpoint simulate --v0 0 --x0 1 --p 1 --f 0.02 --delta 0\n"
                "  stillpoint simulate --velocity 0.4 --period 3 --f 0.02 --delta-m 0.01 \\\n"
                "      --trajectory motion.csv --samples 500\n"
                "Exit codes: 0 done, 2 wrong input.",
                run_simulate},
};

constexpr std::string_view about =
    "Designs friction dampers: a linear oscillator with constant friction f and point friction "
    "delta\n"
    "at x = 0, set off with velocity v0, is to stop at x = 0 with a peak of at most beta.";

constexpr std::string_view epilogue =
    "A scene is a JSON file whose keys are the options' names; a flag overrides it. \"-\" reads it "
    "from\nstandard input. \"stillpoint COMMAND --help\" lists the options of a command.";

/// What CLI11 collects for one subcommand; texts, which are converted once the command is known.
struct Collected {
  std::string scene;
  std::map<std::string_view, std::vector<std::string>> texts;
  std::map<std::string_view, bool> flags;
};

void add_options(CLI::App& app, const CommandLine& line, Collected& collected) {
  app.set_help_flag("-h,--help", "print this text");
  app.add_flag_callback(
         "--version", [] { throw CLI::CallForVersion(version_line(), 0); }, "print the version")
      ->configurable(false);
  app.add_option("scene", collected.scene, "scene file in JSON, or - for standard input")
      ->type_name("");
  for (const Option& option : options()) {
    if (!option.serves(line.command)) {
      continue;
    }
    const std::string flag = fmt::format("--{}", option.name);
    CLI::Option* added =
        option.kind == OptionKind::flag
            ? app.add_flag(flag, collected.flags[option.name], std::string(option.help))
            : app.add_option(flag, collected.texts[option.name], std::string(option.help))
                  ->type_name(std::string(option.placeholder))
                  ->expected(1)
                  ->allow_extra_args(false)
                  ->take_all();
    added->group(std::string(option.group));
  }
  app.footer(std::string(line.examples));
  app.allow_extras();
}

void refuse_extras(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) {
    return;
  }
  const std::string& first = extras.front();
  if (!first.starts_with("-")) {
    throw UsageError(fmt::format("{}: unexpected, only one scene can be given", first));
  }
  std::string_view bare = first;
  bare.remove_prefix(std::min(bare.find_first_not_of('-'), bare.size()));
  bare = bare.substr(0, bare.find('='));
  const Option* known = find_option(bare);
  throw UsageError(known != nullptr ? fmt::format("{}: is no option of {}", first, app.get_name())
                                    : fmt::format("{}: unknown option{}", first, suggestion(bare)));
}

Settings from_flags(const CLI::App& app, const Collected& collected) {
  Settings settings;
  for (const Option& option : options()) {
    const CLI::Option* given = app.get_option_no_throw(fmt::format("--{}", option.name));
    if (given == nullptr || given->count() == 0) {
      continue;
    }
    if (given->count() > 1) {
      throw UsageError(fmt::format("--{} is given {} times: an option may stand only once",
                                   option.name, given->count()));
    }
    if (option.kind == OptionKind::flag) {
      settings.set(option, collected.flags.at(option.name));
      continue;
    }
    const std::string& text = collected.texts.at(option.name).front();
    if (option.kind == OptionKind::number) {
      settings.set(option, parse_number(option.name, text));
    } else if (option.kind == OptionKind::integer) {
      settings.set(option, parse_integer(option.name, text));
    } else {
      settings.set(option, text);
    }
  }
  return settings;
}

/// A scene may serve several commands; what this one does not use is said, not passed over.
void note_unused(const Settings& scene, Command command) {
  scene.for_each_name([&](std::string_view name_of_option) {
    if (!find_option(name_of_option)->serves(command)) {
      fmt::print(stderr, "stillpoint: note: {} in the scene is not used by {}\n", name_of_option,
                 name(command));
    }
  });
}

int run_command(const CommandLine& line, const CLI::App& app, const Collected& collected) {
  refuse_extras(app);
  Settings settings = from_flags(app, collected);
  if (!collected.scene.empty()) {
    const Settings scene = read_scene(collected.scene);
    note_unused(scene, line.command);
    settings.complete_with(scene);
  }
  Output output;
  const ExitCode code = line.run(settings, output);
  output.commit();
  return code;
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app{std::string(about), "stillpoint"};
  app.set_help_flag("-h,--help", "print this text");
  app.set_version_flag("--version", version_line())->description("print the version");
  app.allow_extras();
  app.footer(std::string(epilogue));
  std::array<Collected, command_lines.size()> collected;
  std::array<CLI::App*, command_lines.size()> subcommands{};
  for (std::size_t i = 0; i < command_lines.size(); ++i) {
    const CommandLine& line = command_lines[i];
    subcommands[i] = app.add_subcommand(std::string(name(line.command)), std::string(line.summary));
    add_options(*subcommands[i], line, collected[i]);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    Output output;
    output.print(dynamic_cast<const CLI::CallForVersion*>(&asked) != nullptr
                     ? fmt::format("{}\n", asked.what())
                     : app.help());
    output.commit();
    return exit_done;
  }
  for (std::size_t i = 0; i < command_lines.size(); ++i) {
    if (subcommands[i]->parsed()) {
      return run_command(command_lines[i], *subcommands[i], collected[i]);
    }
  }
  const std::vector<std::string> extras = app.remaining();
  throw UsageError(fmt::format("{}: must be design, region or simulate (stillpoint --help)",
                               extras.empty() ? "no command" : "command " + extras.front()));
}

}  // namespace

int run(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fputs("stillpoint: ", stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return exit_wrong_input;
  }
}

}  // namespace stillpoint::cli
