// SPDX-License-Identifier: MIT
// What engine.js calls: requests and answers are texts of JSON, columns of numbers are memory.

#include "input/excitation.hpp"
#include "input/motion.hpp"
#include "input/request.hpp"
#include "options/scene.hpp"

#include <stillpoint/answers/answers.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/sheet.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

extern "C" {
/// How far a search is, in words; of library.js.
void stillpoint_progress(const char* words);
}

namespace stillpoint::cli {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string said;             // the text that was returned last
std::string behind;           // what stands in it behind the JSON, each part after a separator
std::vector<double> numbers;  // the columns that were computed last

constexpr char separator = '\x1e';  // which JSON escapes

bool always() {
  return true;
}

/// A string is read as on the command line, anything else as in a scene.
Settings given(Command command, const json& options) {
  Settings texts;
  json scene = json::object();
  for (const auto& [key, value] : options.items()) {
    const std::string name = records::hyphened(key);
    const Option* const option = find_option(name);
    if (value.is_string() && option != nullptr && option->kind != OptionKind::flag) {
      texts.set_text(*option, value.get<std::string>(), command);
    } else {
      scene[name] = value;
    }
  }
  Settings settings = scene_settings(scene, command);
  settings.complete_with(texts);
  return scene_and_flags(command, {}, settings);
}

/// Its report, if wanted, and figures stand behind it.
template <class Report>
ordered_json said_of(const Report& report, const json& request) {
  behind = separator;
  if (request.at("report").get<bool>()) {
    behind += report::json_text(report::json(report));
  }
  ordered_json drawn = ordered_json::array();
  // The page draws no figure of a design: the region's are the same.
  if constexpr (!std::is_same_v<Report, report::DesignReport>) {
    if (const json& wanted = request.at("figures"); !wanted.empty()) {
      for (const figures::Figure& figure : drawings(report)) {
        if (std::ranges::find(wanted, json(figure.id)) != wanted.end()) {
          drawn.push_back(
              {{"id", figure.id}, {"title", figure.title}, {"caption", figure.caption()}});
          behind += separator + svg(figure, figures::Frame::in_page);
        }
      }
    }
  }
  ordered_json answer{{"exit", static_cast<int>(answers::exit_code(report))}, {"figures", drawn}};
  if constexpr (!std::is_same_v<Report, report::MotionReport>) {
    if (const auto asked = request.find("sheet"); asked != request.end()) {
      const auto command = request.at("command").get<std::string>();
      const auto made = sheet(report, {{asked->at("title").get<std::string>(), command,
                                        asked->at("scene").get<std::string>()},
                                       "",
                                       report::sheet_date()});
      answer["sheet"] = made ? ordered_json(*made) : ordered_json();
    }
  }
  return answer;
}

// A page waits for its answer: both take less than a second.
constexpr double most_half_cycles = 1e6;  // in a notch with a width
constexpr std::int64_t most_arrivals = 100;

Settings within_limits(Settings settings) {
  if (const auto arrivals = settings.integer("arrivals"); arrivals > most_arrivals) {
    throw InputError("arrivals", fmt::format("{}", *arrivals),
                     fmt::format("must be at most {} on this page; the program takes {}",
                                 most_arrivals, design::most_arrivals));
  }
  if (!settings.has("half-cycle-limit")) {
    settings.set("half-cycle-limit", most_half_cycles);
  }
  return settings;
}

/// Of records, and of what closed forms do not know: each damper is simulated.
report::RecordDesignReport searched(report::RecordDesignInput input) {
  using Clock = std::chrono::steady_clock;
  input.request.threads = 1;
  Clock::time_point told = Clock::now();
  const auto tell = [&](const design::RecordProgress& now) {
    if (Clock::now() - told > std::chrono::milliseconds(100)) {
      told = Clock::now();
      stillpoint_progress(report::progress_words(now, input.physical).c_str());
    }
    return true;
  };
  return {design::design(input.request, tell), input};
}

ordered_json said_by(Command command, const Settings& settings, const json& request) {
  if (command == Command::simulate) {
    return said_of(motion_report(settings, always), request);
  }
  if (command != Command::design && command != Command::region) {
    throw UsageError(fmt::format("{} works only on the command line", name(command)));
  }
  if (takes_cases(settings) && command == Command::design && request.at("quick").get<bool>()) {
    return {{"exit", 0}, {"figures", json::array()}, {"searches", true}};
  }
  return answer_dampers(settings, command, searched,
                        [&](const auto& report) { return said_of(report, request); });
}

ordered_json run(const json& request) {
  const auto wanted = request.at("command").get<std::string>();
  const Command command = parse<Command>(wanted).value_or(Command::init);
  const Settings settings = within_limits(given(command, request.at("options")));
  ordered_json answer = said_by(command, settings, request);
  answer["doubts"] = warnings(settings, command);
  return answer;
}

void motion(const json& options, int points) {
  Settings settings = given(Command::simulate, options);
  settings.set("samples", static_cast<std::int64_t>(points));
  const report::MotionReport report = motion_report(settings, always);
  const std::vector<TracedState>& states = report.answer.trajectory;
  numbers.clear();
  for (double TracedState::*const value : {&TracedState::tau, &TracedState::x, &TracedState::v}) {
    for (const TracedState& state : states) {
      numbers.push_back(state.*value);
    }
  }
}

/// The results of free_batch, without its lanes, which would be a tenth of all code here; of a
/// pulse the last column is its peak.
void batch(const json& options, std::size_t size, const double* columns) {
  const Settings settings = given(Command::simulate, options);
  const MotionInput input = motion_input(settings, Command::simulate, true);
  const Surface surface = surface_input(settings, input.physical);
  Oscillator oscillator = mass_input(settings, input.p);
  auto load = excitation_input(settings, input.physical, input.p);
  numbers.resize(3 * size);
  for (std::size_t i = 0; i < size; ++i) {
    oscillator.f = columns[i];
    oscillator.delta = columns[size + i];
    const double strength = columns[2 * size + i];
    const Start start{.x0 = 0, .v0 = load ? 0 : strength};
    if (load) {
      std::visit(
          [strength](auto& wave) {
            if constexpr (requires { wave.k; }) {
              wave.k = strength;
            }
          },
          load->excitation);
    }
    const Response found =
        !load && surface.plain()
            ? free_response(oscillator, start, {.times = false, .margin = false})
            : forced_response(oscillator, start, load ? load->excitation : NoExcitation{}, {},
                              surface);
    numbers[i] = found.peak_amplitude;
    numbers[size + i] = found.stop_position.value_or(0);
    numbers[2 * size + i] = static_cast<double>(found.outcome);
  }
}

/// The rows of the options that the page takes.
ordered_json option_rows() {
  ordered_json rows = ordered_json::array();
  for (const Option& option : options()) {
    if (!option.is_explored()) {
      continue;
    }
    std::vector<std::string_view> takers;
    for (const Command command : {Command::design, Command::region, Command::simulate}) {
      if (option.serves(command)) {
        takers.push_back(name(command));
      }
    }
    const Units units = option.traits.units;
    const auto in_units = records::units_of(option.traits.dimension);
    rows.push_back({{"name", option.name},
                    {"help", option.help},
                    {"values", option.values()},
                    {"unit", in_units.empty() ? "" : in_units.front().name},
                    {"range", option.takes_range_in(Command::design)},
                    {"units", units == Units::any             ? "any"
                              : units == Units::dimensionless ? "dimensionless"
                                                              : "physical"},
                    {"commands", takers},
                    {"set", static_cast<int>(option.traits.rivals)},
                    {"load", option.names_records()                                 ? "record"
                             : option.name == "pulse" || option.shapes(Load::pulse) ? "pulse"
                             : option.traits.rivals == Rivals::hit                  ? "hit"
                             : option.design_for() == DesignFor::records            ? "record"
                                                                                    : ""},
                    {"simulated", option.traits.design == DesignFor::cases}});
  }
  return rows;
}

/// The text that `work` returns; wrong input as {"error": ...}.
template <class Work>
const char* answered(const Work& work) {
  behind.clear();
  try {
    said = work().dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    said += behind;
  } catch (const std::exception& error) {
    said = ordered_json{{"error", error.what()}}.dump(-1, ' ', false,
                                                      ordered_json::error_handler_t::replace);
  }
  return said.c_str();
}

}  // namespace

}  // namespace stillpoint::cli

using namespace stillpoint;

extern "C" {

/// {version, style, outcomes, options}.
const char* stillpoint_about();
/// Of {command, options, figures, report, sheet, quick}, the ids of the figures to draw, whether a
/// report is wanted, and title and scene of a specification: {exit, figures, doubts, sheet}, the
/// report and the drawings, each after a separator; or {error}. A quick design that would simulate
/// dampers to find the best answers only {searches}.
const char* stillpoint_run(const char* request);
/// "{}" or {error}; then the columns tau, x and v are in stillpoint_numbers().
const char* stillpoint_motion(const char* options, int points);
/// The same of the columns f, delta and v0, or the k of a pulse: peak, position of rest and
/// outcome.
const char* stillpoint_batch(const char* options, int size, const double* columns);
const double* stillpoint_numbers();
int stillpoint_count();

const char* stillpoint_about() {
  return cli::answered([] {
    nlohmann::ordered_json outcomes = nlohmann::ordered_json::array();
    for (int i = 0; i <= static_cast<int>(Outcome::stopped_in_notch); ++i) {
      outcomes.push_back(std::string(name(static_cast<Outcome>(i))));
    }
    return nlohmann::ordered_json{
        {"version", report::program_version()},
        {"style", std::string(figures::figure_style()) + std::string(figures::sheet_style()) +
                      "@media screen and (prefers-color-scheme: dark){" +
                      std::string(figures::dark_figure_style()) + "}"},
        {"outcomes", outcomes},
        {"options", cli::option_rows()}};
  });
}

const char* stillpoint_run(const char* request) {
  return cli::answered([&] { return cli::run(cli::json::parse(request)); });
}

const char* stillpoint_motion(const char* options, int points) {
  return cli::answered([&] {
    cli::motion(cli::json::parse(options), points);
    return nlohmann::ordered_json::object();
  });
}

const char* stillpoint_batch(const char* options, int size, const double* columns) {
  return cli::answered([&] {
    cli::batch(cli::json::parse(options), static_cast<std::size_t>(size), columns);
    return nlohmann::ordered_json::object();
  });
}

const double* stillpoint_numbers() {
  return cli::numbers.data();
}

int stillpoint_count() {
  return static_cast<int>(cli::numbers.size());
}
}
