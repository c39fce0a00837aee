// SPDX-License-Identifier: MIT
#include "text_sections.hpp"

#include "physical_report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stillpoint::cli {

using fmt::format;

std::string in_metres(const std::optional<design::PhysicalInput>& physical, double length) {
  return physical && length != 0
             ? format(" = {}", with_unit(length * physical->scales.length_m, "m"))
             : "";
}

std::string in_seconds(const std::optional<design::PhysicalInput>& physical, double tau) {
  return physical ? format(" = {}", with_unit(tau * physical->scales.time_s, "s")) : "";
}

std::string in_rad_per_s(const std::optional<design::PhysicalInput>& physical, double lambda) {
  return physical ? format(" = {:.5g} rad/s", lambda / physical->scales.time_s) : "";
}

void add_title(Page& page, std::string_view what, const std::optional<std::string>& title) {
  page.title(title ? format("{}: {}", what, spelled_out(*title)) : std::string(what));
}

void add_physical_input(Page& page, const design::PhysicalInput& physical) {
  const design::Scales& scales = physical.scales;
  std::string isolator = format("period {}", with_unit(physical.period_s, "s"));
  if (scales.mass_kg) {
    isolator += format(", mass {:.6g} kg, stiffness {}", *scales.mass_kg,
                       with_unit(*scales.stiffness_n_per_m(), "N/m"));
  }
  page.row("isolator", isolator);
  page.row("velocity", format("{:.6g} m/s", physical.velocity_m_per_s));
  if (physical.max_displacement_m) {
    page.row("max displacement", with_unit(*physical.max_displacement_m, "m"));
  }
  page.row("units",
           format("length H = {}, time {}, gravity {:.6g} m/s2", with_unit(scales.length_m, "m"),
                  with_unit(scales.time_s, "s"), scales.gravity_m_per_s2));
}

void add_problem(Page& page, const design::Problem& problem, const design::Limits& limits,
                 const std::optional<design::PhysicalInput>& physical) {
  page.section("Task");
  if (physical) {
    add_physical_input(page, *physical);
  }
  page.row("dimensionless",
           format("v0 = {:.6g}   p = {:.6g}   beta = {:.6g}", problem.v0, problem.p, problem.beta));
  page.row("criterion", format("{} Delta1", name(problem.criterion)));
  std::string limit;
  const auto add = [&](const std::string& text) { limit += (limit.empty() ? "" : ", ") + text; };
  if (limits.f_max) {
    add(format("f <= {:.6g}", *limits.f_max));
  }
  if (limits.delta_max) {
    add(format("delta <= {:.6g}{}", *limits.delta_max, in_metres(physical, *limits.delta_max)));
  }
  if (limits.tolerance > 0) {
    add(format("tolerance +-{:.4g} %", 100 * limits.tolerance));
  }
  if (!limit.empty()) {
    page.row("limits", limit);
  }
}

void add_region(Page& page, const design::Region& region,
                const std::optional<design::PhysicalInput>& physical) {
  page.section("Admissible region");
  page.row("amplitude",
           format("f >= f2 = {:.6g}{}", region.f2, region.f2 <= 0 ? "  (does not bind)" : ""));
  page.row("return", format("f <= f3 = {:.6g}", region.f3));
  page.row("dead zone", format("f <  f1 = {:.6g}", region.f1));
  page.row("start",
           format("delta <= delta2 = {:.6g}{}", region.delta2, in_metres(physical, region.delta2)));
  page.row("least beta", format("{:.6g}{}", region.beta_min, in_metres(physical, region.beta_min)));
  if (region.feasible) {
    page.row("feasible f", format("{:.6g} .. {:.6g}", *region.f_lower, *region.f_upper));
  }
}

namespace {

/// "at most 0.34", of a physical input in its unit as well.
void add_mend(Page& page, const design::Mend& mend,
              const std::optional<design::PhysicalInput>& physical) {
  std::string physical_value;
  if (physical) {
    if (const auto now = physical_mend(*physical, mend)) {
      physical_value = format("   ({} at {} {} {})", now->name, now->upwards ? "least" : "most",
                              limit_figure(now->value, now->upwards), now->unit);
    }
  }
  page.row(mend.field, format("at {} {}{}", mend.upwards ? "least" : "most",
                              limit_figure(mend.value, mend.upwards), physical_value));
}

}  // namespace

void add_emptiness(Page& page, const std::string& reason, const std::vector<design::Mend>& mends,
                   const std::optional<design::JointMend>& joint,
                   const std::optional<design::PhysicalInput>& physical) {
  page.section("No admissible design");
  page.line(reason, Tone::bad);
  if (joint) {
    page.line(
        format("No single change makes it feasible: whatever beta and the limits are, no damper "
               "has a tolerance above {}. The smallest changes of two inputs that make it "
               "feasible:",
               limit_figure(joint->largest_tolerance, false)));
  } else if (mends.empty()) {
    page.line("No change of a single input makes it feasible.");
  } else {
    page.line("Changing any one of these makes it feasible; each value is the nearest that does:");
  }
  for (const design::Mend& mend : joint ? joint->mends : mends) {
    add_mend(page, mend, physical);
  }
}

void add_constraints(Page& page, std::span<const design::Constraint> constraints) {
  page.section("Constraints");
  std::vector<std::vector<std::string>> rows{{"", "", "value", "", "limit", "slack", ""}};
  std::vector<Tone> tones{Tone::plain};
  for (const design::Constraint& now : constraints) {
    rows.push_back({std::string(now.name), std::string(now.variable), figure(now.value),
                    std::string(now.relation), figure(now.limit), figure(now.slack),
                    now.satisfied ? "ok" : "violated"});
    tones.push_back(now.satisfied ? Tone::good : Tone::bad);
  }
  page.table(rows, tones);
}

void add_damper_physics(Page& page, const design::PhysicalInput& physical, double f, double delta) {
  if (const auto force = physical.scales.friction_force_n(f)) {
    page.row("friction force", with_unit(*force, "N"));
  }
  if (const auto energy = physical.scales.energy_per_passage_j(delta);
      energy && std::isfinite(*energy)) {
    page.row("energy a passage", with_unit(*energy, "J"));
  }
}

namespace {

std::string verdict(const design::CheckMethod& method) {
  if (!method.passed) {
    return "disagrees";
  }
  return method.decided ? "agrees" : "agrees in the peak; too near a tie to tell more";
}

}  // namespace

void add_checks(Page& page, const design::CrossCheck& check) {
  page.section(check.passed ? "Cross-check: agrees" : "Cross-check: DISAGREES");
  std::vector<std::vector<std::string>> rows{
      {"", "peak", "stop time", "half-cycles", "relative error", "allowed", "time", ""}};
  std::vector<Tone> tones{Tone::plain};
  for (const design::CheckMethod& method : check.methods) {
    rows.push_back({std::string(method.name), figure(method.peak_amplitude),
                    figure(method.stop_time), format("{:.0f}", method.half_cycles),
                    format("{:.1e}", method.relative_error), format("{:.1e}", method.tolerance),
                    format("{:.1f} us", 1e6 * method.wall_time_s), verdict(method)});
    tones.push_back(method.passed ? Tone::good : Tone::bad);
  }
  page.table(rows, tones);
}

}  // namespace stillpoint::cli
