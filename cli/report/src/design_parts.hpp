// SPDX-License-Identifier: MIT
#pragma once

// The parts of the document of a design.

#include "sections.hpp"

#include <stillpoint/report/report.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

/// The best is at the very end of the feasible f, no constant friction: a limit, which the search
/// comes near and nobody builds.
[[nodiscard]] bool wants_no_friction(const DesignReport& report);

/// Whether nobody can build it, because f, or f and delta, have next to no tolerance. A part is
/// what it is.
[[nodiscard]] bool is_too_exact(const DesignReport& report);

/// "the strongest hit, 0.44 m/s, and the softest spring, 2.94 s" or "k = 0.5 g": which
/// motion of a task with ranges is shown; empty without.
[[nodiscard]] std::string shown_motion(const DesignReport& report, const Physical& physical);

/// A position of rest; 0 if that is next to nothing of the stroke.
[[nodiscard]] std::string rest_shown(const DesignReport& report, double x);

/// What to build.
[[nodiscard]] std::string verdict(const DesignReport& report, const Physical& physical);
/// The sentences behind that, each after a blank.
[[nodiscard]] std::string remarks(const DesignReport& report, const Physical& physical);
/// What the structure feels, and where.
[[nodiscard]] std::string felt_words(const DesignReport& report, const Physical& physical);
/// Of the document of a design.
[[nodiscard]] Tone tone_of(const DesignReport& report);

/// What it does, and how far it can be trusted.
void add_answer(Section& answer, const DesignReport& report, const Physical& physical);

/// "Runge-Kutta" for the runge_kutta of the JSON report.
[[nodiscard]] std::string_view method_words(std::string_view name);

/// The motion that the answer describes: with the notch that will be built, if that is given.
[[nodiscard]] const Response& told_motion(const DesignReport& report);
/// With ranges and a built notch, in place of that.
[[nodiscard]] std::optional<ToldMotion::Tried> tried_in_built_notch(const DesignReport& report,
                                                                    const Physical& physical);
/// What the structure feels with a built notch that has a width or holds the mass throughout, and
/// of which motion that is.
[[nodiscard]] std::optional<std::string> felt_in_built_notch(const DesignReport& report);
/// "the peak exceeds 150 mm": what the notch that was asked for, and tried, spoils; empty if
/// nothing.
[[nodiscard]] std::string built_notch_fault(const DesignReport& report);
/// Under a pulse without a built notch, that the motion starts in it, and the command that tries
/// one; else empty.
[[nodiscard]] std::string late_notch_words(const DesignReport& report,
                                           std::string_view command = "");
/// An admissible damper as a design; without a finding if it is not.
[[nodiscard]] DesignReport as_design(const RegionReport& report);
/// What the mass feels in the notch, under a pulse or if that has a limit; else empty.
[[nodiscard]] std::string inside_limit(const DesignReport& report, const Physical& physical);
/// As it would be ordered: 29 mm.
[[nodiscard]] double of_two_digits(const Physical& physical, double length);
/// Under a pulse, as the sentence of the notch then says.
[[nodiscard]] bool no_notch_works(const DesignReport& report);
/// From rest under the weakest pulse.
[[nodiscard]] StartUnderLoad start_under_pulse(const design::DesignResult& result);
/// What a notch as built is compared with: "has no width", "holds any load", "acts only after the
/// start".
[[nodiscard]] std::string_view ideal_words(const design::BuiltNotch& built,
                                           const design::Found& finding);
/// ", with a notch that has no width" behind what is not of the notch as built; empty without one.
[[nodiscard]] std::string with_ideal(const DesignReport& report);
/// How the notch as built, which is given, compares with the paper's.
void add_built_notch(Document& document, const DesignReport& report, const Physical& physical);

}  // namespace stillpoint::report
