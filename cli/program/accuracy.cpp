// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "input/request.hpp"

#include <stillpoint/peers/comparison.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::cli {

ExitCode run_accuracy(const Settings& settings, Output& output) {
  const SimulateInput input = simulate_input(settings);
  const peers::Scene scene = peers::comparison_scene(input.request);
  print_report(
      report::AccuracyReport{input.request, peers::compare(scene), input.record, input.physical},
      settings, output);
  return exit_done;
}

}  // namespace stillpoint::cli
