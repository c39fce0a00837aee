// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "input/request.hpp"
#include "messages.hpp"
#include "progress.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>

namespace stillpoint::cli {

ExitCode run_record_design(const Settings& settings, Output& output) {
  const report::RecordDesignInput input = record_design_input(settings);
  design::RecordProgress last;
  Progress progress([&](double, double) { return report::progress_words(last, input.physical); },
                    1);
  const auto show = [&](const design::RecordProgress& now) {
    last = now;
    return progress.goes_on(
        std::min(1.0, static_cast<double>(now.evaluations) / static_cast<double>(now.expected)));
  };
  const report::RecordDesignReport report{design::design(input.request, show), input.physical};
  return finish(report, Command::design, settings, output);
}

}  // namespace stillpoint::cli
