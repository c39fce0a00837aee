// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/report/sweep.hpp>
#include <stillpoint/report/terminal.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <vector>

namespace stillpoint::cli {

namespace {

/// The options that make the numbers, as a scene.
std::string scene_of(const Settings& settings, Command command) {
  nlohmann::ordered_json scene = nlohmann::ordered_json::object();
  for (const auto& [name, value] : settings.values()) {
    const Option& option = *find_option(name);
    const bool for_the_trajectory = (name == "t-end" || name == "end-time") &&
                                    !settings.has("excitation") && !settings.has("record");
    if (option.is_echoed() && option.serves(command) && !for_the_trajectory) {
      const auto given = settings.with_unit(name);
      const std::vector<std::string> texts =
          option.repeats_in(command) ? settings.texts(name) : std::vector<std::string>();
      scene[std::string(name)] = given              ? nlohmann::ordered_json(*given)
                                 : texts.size() > 1 ? nlohmann::ordered_json(texts)
                                                    : as_json(value);
    }
  }
  constexpr int indent = 2;
  return scene.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::string shown(const report::Document& document, const Settings& settings) {
  return text(document, {.title = settings.text("title").value_or(""),
                         .coloured = report::terminal_has_colours(),
                         .verbosity = settings.flag("verbose") ? report::Verbosity::full
                                                               : report::Verbosity::normal});
}

std::span<const std::string_view> figure_names(Command command) {
  switch (command) {
    case Command::design:
      return report::all_design_figures();
    case Command::region:
      return report::region_figures;
    case Command::simulate:
      return report::motion_figures;
    case Command::spectrum:
      return report::spectrum_figure_names;
    case Command::sweep:
      return report::sweep_figures;
    case Command::accuracy:
    case Command::init:
      break;
  }
  return {};
}

std::string svg_path(const std::string& directory, std::string_view figure) {
  return (std::filesystem::path(directory) / fmt::format("{}.svg", figure)).string();
}

bool wants_page(const Settings& settings) {
  return settings.has("html") || settings.has("svg");
}

void prepare_page(const Settings& settings) {
  if (const auto directory = settings.text("svg")) {
    sweep::make_directory("svg", *directory);
  }
  if (const auto path = settings.text("html")) {
    sweep::require_directory_of("html", *path);
  }
}

void write_page(const Settings& settings, Command command, figures::HtmlPage page, Output& output) {
  report::add_frame(
      page, {settings.text("title").value_or(""), name(command), scene_of(settings, command)});
  if (const auto path = settings.text("html")) {
    output.write_file("html", *path, html(page));
  }
  const auto directory = settings.text("svg");
  if (!directory) {
    return;
  }
  sweep::make_directory("svg", *directory);
  for (const figures::Figure& figure : page.figures) {
    assert(std::ranges::count(figure_names(command), figure.id) == 1);
    output.write_file("svg", svg_path(*directory, figure.id), svg(figure, figures::Frame::alone));
  }
}

}  // namespace stillpoint::cli
