// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <stillpoint/records/text.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/report/sweep.hpp>
#include <stillpoint/report/version.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <system_error>
#include <vector>

namespace stillpoint::cli {

namespace {

using fmt::format;

constexpr std::size_t longest_title = 400;

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

std::string input_section(Command command, const std::string& scene) {
  return format(
      "<section><h2>Input</h2>\n<p>As <code>scene.json</code>; <code>stillpoint {} scene.json "
      "--html "
      "page.html</code> gives this page again.</p>\n<pre>{}</pre></section>\n",
      name(command), figures::escaped(scene));
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

}  // namespace

std::span<const std::string_view> figure_names(Command command) {
  switch (command) {
    case Command::design: {
      static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> list(report::design_figures.begin(),
                                           report::design_figures.end());
        list.insert(list.end(), report::record_design_figures.begin(),
                    report::record_design_figures.end());
        list.insert(list.end(), report::spectrum_figure_names.begin(),
                    report::spectrum_figure_names.end());
        return list;
      }();
      return all;
    }
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
  return (std::filesystem::path(directory) / format("{}.svg", figure)).string();
}

bool wants_page(const Settings& settings) {
  return settings.has("html") || settings.has("svg");
}

void prepare_page(const Settings& settings) {
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

void write_page(const Settings& settings, Command command, figures::HtmlPage page, Output& output) {
  if (const auto title = settings.text("title")) {
    page.title += ": " + records::printable(*title, longest_title);
  }
  page.body += input_section(command, scene_of(settings, command));
  page.footer = report::version_line();
  const auto directory = settings.text("svg");
  if (directory) {
    make_directory(*directory);
  }
  if (const auto path = settings.text("html")) {
    output.write_file("html", *path, html(page));
  }
  for (const figures::Figure& figure : page.figures) {
    if (directory) {
      assert(std::ranges::count(figure_names(command), figure.id) == 1);
      output.write_file("svg", svg_path(*directory, figure.id), svg(figure, figures::Frame::alone));
    }
  }
}

}  // namespace stillpoint::cli
