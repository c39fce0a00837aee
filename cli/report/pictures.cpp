// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include "figures_motion.hpp"
#include "figures_region.hpp"
#include "figures_sweep.hpp"
#include "page.hpp"
#include "text_report.hpp"
#include "text_sections.hpp"
#include "version.hpp"

#include <stillpoint/core/forced_half_cycles.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <numbers>
#include <span>
#include <system_error>

namespace stillpoint::cli {

using figures::Figure;
using figures::Frame;
using figures::HtmlPage;
using figures::HtmlTable;
using figures::Ink;

namespace {

using fmt::format;

constexpr std::size_t longest_title = 400;

/// The options that make the numbers, as a scene.
std::string scene_of(const Settings& settings, Command command) {
  nlohmann::ordered_json scene = nlohmann::ordered_json::object();
  settings.for_each([&](std::string_view option, const Settings::Value& value) {
    const bool for_the_trajectory =
        option == "t-end" && !settings.has("excitation") && !settings.has("record");
    if (!is_echoed(option) || for_the_trajectory || !find_option(option)->serves(command)) {
      return;
    }
    std::visit(
        [&](const auto& plain) {
          if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, Axis>) {
            scene[std::string(option)] = plain.text();
          } else {
            scene[std::string(option)] = plain;
          }
        },
        value);
  });
  constexpr int indent = 2;
  return scene.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

HtmlTable constraint_table(std::span<const design::Constraint> constraints) {
  HtmlTable table{"Constraints", {{"name", "of", "value", "", "limit", "slack", ""}}};
  for (const design::Constraint& now : constraints) {
    table.rows.push_back({std::string(now.name), now.variable == "delta" ? "Δ" : "f",
                          figure(now.value), std::string(now.relation), figure(now.limit),
                          figure(now.slack), now.satisfied ? "kept" : "VIOLATED"});
  }
  return table;
}

HtmlTable check_table(const design::CrossCheck& check) {
  HtmlTable table{
      check.passed ? "Checks: they agree" : "Checks: THEY DISAGREE",
      {{"method", "peak", "stop time", "half-cycles", "relative error", "allowed", ""}}};
  for (const design::CheckMethod& method : check.methods) {
    table.rows.push_back(
        {std::string(method.name), figure(method.peak_amplitude), figure(method.stop_time),
         format("{:.0f}", method.half_cycles), format("{:.1e}", method.relative_error),
         format("{:.1e}", method.tolerance), method.passed ? "agrees" : "DISAGREES"});
  }
  return table;
}

/// Empty: the motion is short enough to be drawn whole.
std::optional<double> end_of_beginning(std::int64_t half_cycles,
                                       const std::vector<HalfCycle>& listed) {
  if (half_cycles < most_drawn_half_cycles) {
    return std::nullopt;
  }
  return listed.back().end_time;
}

std::vector<HalfCycle> drawable_half_cycles(const SimulateInput& input) {
  return first_half_cycles(input.request.oscillator, input.request.start, most_drawn_half_cycles);
}

DrawnMotion drawn(const SimulateInput& input, const Simulation& answer) {
  if (!is_forced(input.request)) {
    const auto listed = drawable_half_cycles(input);
    const auto cut = end_of_beginning(static_cast<std::int64_t>(listed.size()), listed);
    DrawnMotion motion = drawn_free_motion(input.request.oscillator, input.request.start, cut);
    motion.whole = !cut;
    return motion;
  }
  const Excitation& excitation = input.request.excitation;
  const double horizon = answer.horizon;
  const double rate = fastest_rate(input.request.oscillator.p, excitation);
  double last = std::min(horizon, most_drawn_periods * 2 * std::numbers::pi / rate);
  const auto listed = forced_half_cycles(input.request.oscillator, input.request.start, excitation,
                                         last, most_drawn_half_cycles, {});
  last = std::min(
      last, end_of_beginning(static_cast<std::int64_t>(listed.size()), listed).value_or(last));
  // Where the mass rests for good there is little to see.
  constexpr double seen_at_rest = 1.25;
  const auto& stop_time = answer.forced->stop_time;
  const bool rests = stop_time && *stop_time > 0;
  if (rests) {
    last = std::min(last, seen_at_rest * *stop_time);
  }
  DrawnMotion motion =
      drawn_forced_motion(input.request.oscillator, input.request.start, excitation, last);
  if (rests && last >= *stop_time && !motion.rest) {  // known to be the final one only later
    motion.rest = State{*stop_time, *answer.forced->stop_position, 0};
  }
  motion.whole = last >= horizon || (rests && last >= *stop_time);
  return motion;
}

bool moves(const DrawnMotion& motion) {
  return motion.states.back().tau > 0;
}

void make_directory(const std::string& path) {
  if (path.empty()) {
    throw UsageError("svg: the name of the directory is empty");
  }
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    throw UsageError(format("svg {}: {}", path, error.message()));
  }
}

std::optional<design::PulseProblem> pulse_problem(const std::optional<design::Pulse>& pulse,
                                                  const design::Problem& problem) {
  return pulse ? std::optional(
                     design::PulseProblem{*pulse, problem.p, problem.beta, problem.criterion})
               : std::nullopt;
}

/// The design as its pulse moves it, from rest.
Figure pulse_figure(const design::Pulse& pulse, const design::Problem& problem,
                    const design::Finding& found, const FigureUnits& units) {
  const Excitation shaking = design::excitation(pulse);
  const double ends = duration(shaking).value();
  constexpr double periods = 3;  // where it does not stop
  constexpr double behind_the_end = 1.04;
  const double horizon = behind_the_end * found.pulse->response.stop_time.value_or(
                                              ends + periods * 2 * std::numbers::pi / problem.p);
  DrawnMotion motion = drawn_forced_motion({problem.p, found.point.f, found.point.delta}, {0, 0},
                                           shaking, std::max(horizon, ends));
  motion.beta = problem.beta;
  Figure figure = motion_figure(motion, units);
  figure.id = "pulse";
  figure.title = "Motion under the pulse itself";
  figure.bands.insert(figure.bands.begin(), {"pulse", 0, ends * units.time, Ink::sky});
  return figure;
}

}  // namespace

std::span<const std::string_view> figure_names(Command command) {
  static constexpr std::array<std::string_view, 5> of_design{"region", "motion", "phase", "energy",
                                                             "pulse"};
  static constexpr std::array<std::string_view, 1> of_region{"region"};
  static constexpr std::array<std::string_view, 4> of_simulate{"motion", "phase", "energy",
                                                               "excitation"};
  static constexpr std::array<std::string_view, 1> of_sweep{"map"};
  switch (command) {
    case Command::design:
      return of_design;
    case Command::region:
      return of_region;
    case Command::simulate:
      return of_simulate;
    case Command::sweep:
      return of_sweep;
    case Command::accuracy:
      break;
  }
  return {};
}

std::string svg_path(const std::string& directory, std::string_view figure) {
  return (std::filesystem::path(directory) / format("{}.svg", figure)).string();
}

bool wants_pictures(const Settings& settings) {
  return settings.has("html") || settings.has("svg");
}

void prepare_pictures(const Settings& settings) {
  if (const auto directory = settings.text("svg")) {
    make_directory(*directory);
  }
  if (const auto path = settings.text("html")) {
    const std::filesystem::path folder = std::filesystem::path(*path).parent_path();
    std::error_code unknown;
    if (!folder.empty() && !std::filesystem::is_directory(folder, unknown)) {
      throw UsageError(format("html {}: there is no directory {}", *path, folder.string()));
    }
  }
}

HtmlPage design_page(const DesignInput& input, const design::DesignResult& result) {
  const auto& [problem, limits, search, pulse] = result.request;
  const FigureUnits units(input.physical);
  HtmlPage page;
  page.title = "Damper design";
  page.report = design_text(input, result, {}, Style(false));
  if (!result.finding) {
    page.verdict = "No admissible design: " + result.reason;
    page.figures = {region_figure({problem, limits, result.region, {}, {}}, units)};
    return page;
  }
  const design::Finding& found = *result.finding;
  const auto& [f, delta, tolerance] = found.point;
  page.verdict = format("f = {:.6g}, Δ = {:.6g}{}; both may be off by ±{:.4g} %. The checks {}.", f,
                        delta, in_metres(input.physical, delta), 100 * tolerance,
                        found.cross_check.passed ? "agree" : "DISAGREE");
  DrawnMotion motion = drawn_free_motion({problem.p, f, delta}, {0, problem.v0}, {});
  motion.beta = problem.beta;
  page.figures = {
      region_figure({problem, limits, result.region, DrawnDamper{"design", f, delta, tolerance},
                     pulse_problem(pulse, problem)},
                    units),
      motion_figure(motion, units), phase_figure(motion, units), energy_figure(motion, units)};
  if (found.pulse) {
    for (Figure& figure : page.figures) {
      figure.title += figure.id == "region" ? "" : ", reduced to V0";
    }
    for (const design::PulseWarning warning : found.pulse->warnings) {
      page.verdict += warning == design::PulseWarning::pulse_not_short
                          ? " The pulse is not short: the reduction to V0 is rough."
                          : " Friction is not small against the pulse.";
    }
    page.figures.push_back(pulse_figure(*pulse, problem, found, units));
  }
  page.tables = {constraint_table(found.constraints), check_table(found.cross_check)};
  return page;
}

HtmlPage region_page(const RegionInput& input, const design::RegionAnswer& answer) {
  HtmlPage page;
  page.title = "Admissible region";
  page.report = region_text(input, answer, {}, Style(false));
  page.verdict = answer.region.feasible ? format("Feasible f: {:.6g} to {:.6g}.",
                                                 *answer.region.f_lower, *answer.region.f_upper)
                                        : "No admissible design: " + answer.reason;
  std::optional<DrawnDamper> damper;
  if (input.request.delta) {
    damper = {*answer.admissible ? "point, admissible" : "point, not admissible", *input.request.f,
              *input.request.delta, answer.tolerance.value_or(0)};
    page.tables = {constraint_table(answer.constraints)};
  }
  page.figures = {
      region_figure({input.request.problem, input.request.limits, answer.region, damper, {}},
                    FigureUnits(input.physical))};
  return page;
}

HtmlPage simulate_page(const SimulateInput& input, const Simulation& answer) {
  const FigureUnits units(input.physical);
  HtmlPage page;
  page.title = "Simulation";
  page.report = simulate_text(input, answer, {}, Style(false));
  const DrawnMotion motion = drawn(input, answer);
  if (!moves(motion)) {
    page.verdict = "Nothing moves, so there is nothing to draw.";
    return page;
  }
  page.verdict = format("f = {:.6g}, Δ = {:.6g}{}.", input.request.oscillator.f,
                        input.request.oscillator.delta,
                        in_metres(input.physical, input.request.oscillator.delta));
  if (!motion.whole) {
    page.verdict += " The figures show its beginning.";
  }
  page.figures = {motion_figure(motion, units), phase_figure(motion, units)};
  page.figures.push_back(is_forced(input.request)
                             ? excitation_figure(input.request.excitation, motion, units)
                             : energy_figure(motion, units));
  return page;
}

HtmlPage sweep_page(const sweep::SweepSpec& spec, const sweep::SweepSummary& summary,
                    const sweep::SweepMap& map) {
  HtmlPage page;
  page.title = "Sweep";
  page.verdict = format(
      "{} motions. At 0: it rests at x = 0; off 0: in the dead zone; the number is of half-cycles.",
      summary.state.rows);
  if (spec.output) {
    page.report = sweep_text(spec, summary, {}, Style(false));
  }
  page.figures = {sweep_figure(spec, map)};
  return page;
}

void write_pictures(const Settings& settings, Command command, HtmlPage page, Output& output) {
  if (const auto title = settings.text("title")) {
    page.title += ": " + records::printable(*title, longest_title);
  }
  page.command = name(command);
  page.footer = version_line();
  page.scene = scene_of(settings, command);
  const auto directory = settings.text("svg");
  if (directory) {
    make_directory(*directory);
  }
  if (const auto path = settings.text("html")) {
    output.write_file("html", *path, html(page));
  }
  for (const Figure& figure : page.figures) {
    if (directory) {
      assert(std::ranges::count(figure_names(command), figure.id) == 1);
      output.write_file("svg", svg_path(*directory, figure.id), svg(figure, Frame::alone));
    }
  }
}

}  // namespace stillpoint::cli
