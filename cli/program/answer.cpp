// SPDX-License-Identifier: MIT
#include "answer.hpp"

#include "input/excitation.hpp"
#include "input/request.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace stillpoint::cli {

report::MotionReport motion_report(const Settings& settings, const GoOn& go_on) {
  Settings wanted = settings;
  const bool ends_free = !excitation_type(settings) && settings.given(Rivals::end) != nullptr;
  if (settings.has("samples") || ends_free) {
    wanted.set(*find_option("trajectory"), std::string("-"));
  }
  report::MotionReport report = simulate_input(wanted);
  report.answer = simulate(report.request, [&](double /*tau*/) { return go_on(); });
  return report;
}

namespace {

using answers::Answer;
using answers::answer_of;

std::unique_ptr<Answer> design_answer(const Settings& settings, const GoOn& go_on) {
  if (!designs_under_records(settings)) {
    return answer_of(answers::answer(design_input(settings)));
  }
  const report::RecordDesignInput input = record_design_input(settings);
  return answer_of(report::RecordDesignReport{
      design::design(input.request, [&](const auto& /*progress*/) { return go_on(); }),
      input.physical});
}

std::unique_ptr<Answer> spectrum_answer(const Settings& settings, const GoOn& go_on) {
  report::SpectrumReport found = spectrum_input(settings);
  found.result = design::spectrum(found.result.request, [&](double /*done*/) { return go_on(); });
  return answer_of(std::move(found));
}

}  // namespace

std::unique_ptr<answers::Answer> answer(Command command, const Settings& settings,
                                        const GoOn& go_on) {
  switch (command) {
    case Command::design:
      return design_answer(settings, go_on);
    case Command::region:
      return answer_of(answers::answer(region_input(settings)));
    case Command::simulate:
      return answer_of(motion_report(settings, go_on));
    case Command::spectrum:
      return spectrum_answer(settings, go_on);
    case Command::sweep:
    case Command::accuracy:
    case Command::init:
    case Command::explore:
      break;
  }
  throw UsageError(fmt::format("{}: works only on the command line", name(command)));
}

}  // namespace stillpoint::cli
