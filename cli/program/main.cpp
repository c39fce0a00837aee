// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include "commands.hpp"
#include "progress.hpp"
#include "scene.hpp"
#include "written_files.hpp"

#include <stillpoint/report/document.hpp>

#include <fmt/format.h>

#include <cassert>
#include <cstdio>
#include <exception>
#include <string>

namespace stillpoint::cli {

namespace {

void say(const std::string& text) {
  fmt::print(stderr, "stillpoint: {}\n", report::spelled_out(text));
}

/// A scene may serve several commands; what this one does not use is said, not passed over.
void note_unused(const Settings& scene, Command command) {
  for (const auto& [option, value] : scene.values()) {
    if (!find_option(option)->serves(command)) {
      say(fmt::format("note: {} in the scene is not used by {}", option, name(command)));
    }
  }
}

ExitCode run_command(Command command, const Settings& settings, Output& output) {
  switch (command) {
    case Command::design:
      return run_design(settings, output);
    case Command::region:
      return run_region(settings, output);
    case Command::simulate:
      return run_simulate(settings, output);
    case Command::sweep:
      return run_sweep(settings, output);
    case Command::accuracy:
      return run_accuracy(settings, output);
  }
  assert(false && "a Command outside its enumeration");
  return exit_wrong_input;
}

ExitCode answer(const Invocation& invocation, Output& output) {
  if (invocation.reply) {
    output.print(*invocation.reply);
    return exit_done;
  }
  Settings settings = invocation.flags;
  Settings scene;
  if (invocation.scene == "-" && settings.text("list") == "-") {
    throw UsageError("the scene and the list cannot both be standard input: give a file for one");
  }
  if (invocation.scene) {
    scene = read_scene(*invocation.scene, invocation.command);
    settings = scene_and_flags(invocation.command, invocation.flags, scene);
  }
  require_files_apart(invocation.command, settings, invocation.scene);
  const ExitCode code = run_command(invocation.command, settings, output);
  note_unused(scene, invocation.command);
  return code;
}

int run(int argc, const char* const* argv) {
  try {
    Output output;
    const ExitCode code = answer(parse_command_line(argc, argv), output);
    output.commit();
    return code;
  } catch (const Interrupted& interrupted) {
    say(interrupted.what());
    return exit_interrupted;
  } catch (const std::exception& error) {
    say(error.what());
    return exit_wrong_input;
  }
}

}  // namespace

}  // namespace stillpoint::cli

int main(int argc, char** argv) {
  return stillpoint::cli::run(argc, argv);
}
