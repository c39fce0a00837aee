// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "input/request.hpp"

#include <stillpoint/peers/comparison.hpp>

namespace stillpoint::cli {

ExitCode run_accuracy(const Settings& settings, Output& output) {
  const report::MotionReport asked = simulate_input(settings);
  const peers::Scene scene = peers::comparison_scene(asked.request);
  print_report(
      report::AccuracyReport{asked.request, peers::compare(scene), asked.record, asked.physical},
      settings, output);
  return exit_done;
}

}  // namespace stillpoint::cli
