// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "input/request.hpp"
#include "messages.hpp"
#include "options/scene.hpp"
#include "progress.hpp"

#include <stillpoint/report/browser.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <new>

namespace stillpoint::cli {

namespace {

/// A scene may be for several commands; a note names the keys that this one does not use.
void note_unused(const Settings& scene, const Settings& settings, Command command) {
  for (const auto& [option, entry] : scene.entries()) {
    if (!find_option(option)->serves(command) || !settings.has(option)) {
      remark(command == Command::design && asks_for_records(settings)
                 ? fmt::format("note: {} in the scene is not used under records", option)
                 : fmt::format("note: {} in the scene is not used by {}", option, name(command)));
    }
  }
}

/// Opens the page with the program in it, or prints where it is.
void explore(const std::string& wanted, Output& output) {
  const std::string page = report::explorer();
  if (wanted == "path") {
    output.print(page + "\n");
  } else {
    report::open_page(report::browser(), page);
  }
}

ExitCode merge(const Invocation& invocation, Output& output) {
  if (invocation.flags.flag("quiet")) {
    hush();
  }
  return run_merge(*invocation.merge, output);
}

void say_doubts(const std::vector<std::string>& sentences) {
  for (const std::string& warning : sentences) {
    remark(fmt::format("warning: {}", warning));
  }
}

/// A command that has settings.
ExitCode run_command(const Invocation& invocation, Output& output) {
  Settings settings = invocation.flags;
  Settings scene;
  static_cast<void>(files_to_read(invocation.command, invocation.flags, invocation.scene));
  if (invocation.scene) {
    scene = read_scene(*invocation.scene, invocation.command);
    settings = scene_and_flags(invocation.command, invocation.flags, scene);
  }
  if (settings.flag("quiet")) {
    hush();
  }
  // Checks what --open needs before anything long is done: a browser, and a page for it.
  const bool opens = settings.flag("open") && find_option("open")->serves(invocation.command);
  const std::vector<std::string> opener = opens ? report::browser() : std::vector<std::string>();
  std::optional<report::TemporaryPage> temporary;
  if (opens && !settings.has("html")) {
    settings.set("html", temporary.emplace().path());
  }
  if (settings.has("output") || wants_page(settings)) {
    output.answer_in_file();
  }
  ExitCode code = exit_done;
  try {
    code = with_places(settings, [&] {
      resolve_part(settings);
      require_files_apart(invocation.command, settings, invocation.scene);
      return run(invocation.command, settings, output);
    });
  } catch (const TooManyHalfCycles&) {
    say_doubts(warnings(settings, invocation.command));  // which may be why
    throw;
  }
  const std::vector<std::string> sentences = warnings(settings, invocation.command);
  output.commit();
  say_doubts(sentences);
  note_unused(scene, settings, invocation.command);
  if (opens) {
    report::open_page(opener, *settings.text("html"));
  }
  return code;
}

ExitCode answer(const Invocation& invocation, Output& output) {
  ExitCode code = exit_done;
  if (invocation.reply) {
    output.print(*invocation.reply);
  } else if (invocation.merge) {
    code = merge(invocation, output);
  } else if (invocation.command == Command::init) {
    output.print(texts::embedded(fmt::format("starters/{}.json", *invocation.scene)));
  } else if (invocation.command == Command::explore) {
    explore(*invocation.scene, output);
  } else {
    return run_command(invocation, output);
  }
  output.commit();
  return code;
}

int run_program(int argc, const char* const* argv) {
  try {
    open_closed_streams(true);
    outlive_failed_writes();
    if (argc <= 1) {
      write_error(short_help());
      return exit_wrong_input;
    }
    Output output;
    return answer(parse_command_line(argc, argv), output);
  } catch (const Interrupted& interrupted) {
    say(interrupted.what());
    return exit_interrupted;
  } catch (const std::bad_alloc&) {
    say("there is not enough memory for this");
  } catch (const std::exception& error) {
    end_if_nobody_reads();
    say(words_of(error));
  }
  return exit_wrong_input;
}

}  // namespace

}  // namespace stillpoint::cli

int main(int argc, char** argv) {
  return stillpoint::cli::run_program(argc, argv);
}
