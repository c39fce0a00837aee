// SPDX-License-Identifier: MIT
#pragma once

// The sections of which the reports for people are made.

#include "json_report.hpp"
#include "page.hpp"
#include "request.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// " = 12.1 mm" behind a dimensionless length; "" without physical input and for 0.
[[nodiscard]] std::string in_metres(const std::optional<design::PhysicalInput>& physical,
                                    double length);

/// " = 1.53 s" behind a tau; "" without physical input.
[[nodiscard]] std::string in_seconds(const std::optional<design::PhysicalInput>& physical,
                                     double tau);

/// " = 62.8 rad/s" behind an angular frequency; "" without physical input.
[[nodiscard]] std::string in_rad_per_s(const std::optional<design::PhysicalInput>& physical,
                                       double lambda);

void add_title(Page& page, std::string_view what, const std::optional<std::string>& title);
void add_physical_input(Page& page, const design::PhysicalInput& physical);
void add_problem(Page& page, const design::Problem& problem, const design::Limits& limits,
                 const std::optional<design::PhysicalInput>& physical);
void add_region(Page& page, const design::Region& region,
                const std::optional<design::PhysicalInput>& physical);
/// Why there is no admissible design and what would mend it.
void add_emptiness(Page& page, const std::string& reason, const std::vector<design::Mend>& mends,
                   const std::optional<design::JointMend>& joint,
                   const std::optional<design::PhysicalInput>& physical);
void add_constraints(Page& page, std::span<const design::Constraint> constraints);
/// Force and energy, where there is a mass.
void add_damper_physics(Page& page, const design::PhysicalInput& physical, double f, double delta);
/// What a decision margin means: of a free motion, and of a forced one.
constexpr std::string_view free_margin =
    "about so far off may every input be before a count changes";
constexpr std::string_view forced_margin =
    "so near came what decides a count to its limit, of the sizes compared";
void add_response(Page& page, const Response& response,
                  const std::optional<design::PhysicalInput>& physical,
                  std::string_view margin = free_margin);
void add_excitation(Page& page, const SimulateInput& input);
/// What a forced motion has beyond a free one.
void add_forced_response(Page& page, const ForcedResponse& response,
                         const std::optional<design::PhysicalInput>& physical);
void add_checks(Page& page, const design::CrossCheck& check);
/// The first dozen.
void add_half_cycles(Page& page, const Simulation& answer);

}  // namespace stillpoint::cli
