// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/answers/answers.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/box_shape.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/sweep/catalogue_file.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <functional>

namespace stillpoint::cli {

/// Empty if not given. Throws InputError outside 1 to 1e15.
[[nodiscard]] std::optional<double> half_cycle_limit(const Settings& settings);

/// Empty for all of them, which is 0 for the user.
[[nodiscard]] inline Threads threads(const Settings& settings) {
  const auto given = settings.integer("threads").value_or(0);
  return given == 0 ? Threads() : Threads(static_cast<int>(given));
}

/// Each throws UsageError for something missing or contradictory and InputError for a wrong value.
[[nodiscard]] answers::DesignTask design_input(const Settings& asked);
[[nodiscard]] answers::RegionTask region_input(const Settings& asked);
[[nodiscard]] sweep::CatalogueUnits units_of_parts(
    double p, const std::optional<design::PhysicalInput>& physical);
/// The parts of --catalogue, in these units. Throws records::FileError for a wrong file.
[[nodiscard]] std::vector<design::Part> catalogue_input(const Settings& settings,
                                                        sweep::CatalogueUnits units);
/// The question; the answer in these two is empty.
[[nodiscard]] report::MotionReport simulate_input(const Settings& given);
[[nodiscard]] report::SpectrumReport spectrum_input(const Settings& given);
/// With a trajectory if samples or an end ask for one, where no file is named.
[[nodiscard]] Settings traced(Settings settings);
/// With the answer, of traced settings. `go_on` may end the run.
[[nodiscard]] report::MotionReport motion_report(const Settings& settings,
                                                 const std::function<bool()>& go_on);

/// Whether a task is one of load cases: of records, of several, or of a hit or a pulse with what
/// its closed forms do not know. Throws UsageError if records and a hit are given.
[[nodiscard]] bool takes_cases(const Settings& settings);

/// The request of `design`, or of `region` for a damper to judge, and what a report needs besides.
/// Throws UsageError, InputError and FileError.
[[nodiscard]] report::RecordDesignInput record_design_input(const Settings& given, Command command);

/// What `see` makes of the answer of design or region: of the one that `searched` finds for load
/// cases, or of that of the closed forms.
template <class Searched, class See>
auto answer_dampers(const Settings& settings, Command command, const Searched& searched,
                    const See& see) {
  return takes_cases(settings)        ? see(searched(record_design_input(settings, command)))
         : command == Command::design ? see(answers::answer(design_input(settings)))
                                      : see(answers::answer(region_input(settings)));
}

/// Throws UsageError for an option that only the other kind of design takes.
void require_options_for(const Settings& settings, DesignFor design);

/// Why a mass with `beyond`, damping or breakaway, has no published criterion.
[[nodiscard]] std::string published_beyond(std::string_view beyond);

/// Puts the numbers of a part of a sweep in place of `auto`, and its name into that of the output.
/// What is already resolved stays as it is. Throws InputError.
void resolve_part(Settings& settings);
/// Opens the list and reads its header, or for a part all of it. The part must be resolved.
[[nodiscard]] sweep::SweepSpec sweep_request(const Settings& given);
/// Of a tolerance that is given as R or as factors LOW:HIGH. Throws InputError.
[[nodiscard]] std::optional<design::Spread> spread(const Settings& settings, const char* name);
/// --tolerance of a design for a hit as a number; 0 where factors shape the box.
[[nodiscard]] double tolerance_of_hit(const Settings& settings);
/// The box of --tolerance-f and --tolerance-delta around the tolerance of `limits`. Throws
/// InputError.
void shape_box(const Settings& settings, design::Limits& limits);

/// --objective, of the kind that the design takes, which `where` names.
template <class Objective>
[[nodiscard]] Objective objective_of(const Settings& settings, Objective usual,
                                     std::string_view where) {
  const auto wanted = settings.known("objective");
  const auto objective = wanted ? parse<Objective>(*wanted) : std::optional(usual);
  if (!objective) {
    throw InputError("objective", *wanted, records::must_be(*wanted, names<Objective>(), where));
  }
  return *objective;
}

/// A sentence for each doubt about the values, and for each file in a folder of records that is
/// skipped. Throws FileError.
[[nodiscard]] std::vector<std::string> warnings(const Settings& settings, Command command);

/// The options of those names, or their defaults. Throw InputError.
[[nodiscard]] design::Criterion criterion(const Settings& settings);
[[nodiscard]] design::Objective objective(const Settings& settings);

}  // namespace stillpoint::cli
