// SPDX-License-Identifier: MIT
#include "input/excitation.hpp"
#include "input/record.hpp"
#include "input/request.hpp"

namespace stillpoint::cli {

namespace {

/// Of a single motion in metres; empty without a load.
std::optional<design::LoadReach> load_of(const Settings& settings, Command command) {
  const bool pulsed =
      settings.has("pulse") && (command == Command::design || command == Command::region);
  const bool shaken = excitation_type(settings).has_value() &&
                      (command == Command::simulate || command == Command::accuracy);
  if ((!pulsed && !shaken) || !is_physical(settings, command) || settings.has("search-period")) {
    return std::nullopt;
  }
  const MotionInput motion = motion_input(settings, command, true);
  const Excitation load = pulsed
                              ? design::excitation(*pulse_input(settings, motion.physical))
                              : excitation_input(settings, motion.physical, motion.p)->excitation;
  return design::load_reach(load, motion.p, end_of_run(settings, motion.physical),
                            motion.physical->scales);
}

/// The p at which a record is scaled to its spectrum, by the unit of its times; empty if several
/// motions have one each.
std::optional<double> spectrum_p(const Settings& settings, Command command) {
  if ((!settings.has("record-spectrum") && !settings.has("records-list")) ||
      command == Command::sweep || command == Command::spectrum || settings.has("search-period")) {
    return std::nullopt;
  }
  const MotionInput motion = motion_input(settings, command, true);
  return motion.p / (motion.physical ? motion.physical->scales.time_s : 1);
}

}  // namespace

std::vector<std::string> warnings(const Settings& settings, Command command) {
  std::vector<std::string> sentences =
      doubts(settings.over_weight(), command, load_of(settings, command));
  if (find_option("record")->serves(command)) {
    for (const std::string& doubt : records::suite_doubts(
             suite_files(settings), record_scale(settings, {}, spectrum_p(settings, command)),
             record_options(settings, {}))) {
      sentences.push_back(doubt);
    }
  }
  return sentences;
}

}  // namespace stillpoint::cli
