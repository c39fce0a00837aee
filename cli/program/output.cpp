// SPDX-License-Identifier: MIT
#include "output.hpp"

#include "input/excitation.hpp"
#include "input/request.hpp"
#include "messages.hpp"

#include <stillpoint/report/browser.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/page_frame.hpp>

#include <nlohmann/json.hpp>

#include <cassert>
#include <filesystem>

namespace stillpoint::cli {

namespace {

/// The options for which `holds`, as a scene.
template <class Holds>
nlohmann::ordered_json scene_of(const Settings& settings, Command command, const Holds& holds) {
  nlohmann::ordered_json scene = nlohmann::ordered_json::object();
  for (const auto& [name, entry] : settings.entries()) {
    const Option& option = *find_option(name);
    if (option.serves(command) && holds(option)) {
      const std::vector<std::string> texts =
          option.repeats_in(command) ? settings.texts(name) : std::vector<std::string>();
      scene[std::string(name)] = entry.with_unit    ? nlohmann::ordered_json(*entry.with_unit)
                                 : texts.size() > 1 ? nlohmann::ordered_json(texts)
                                 : option.traits.in_scene == InScene::cases
                                     ? nlohmann::ordered_json::parse(*settings.text(name))
                                     : as_json(entry.value);
    }
  }
  return scene;
}

/// The options that decide the numbers.
std::string task_of(const Settings& settings, Command command) {
  const auto is_of_task = [&](const Option& option) {
    return option.is_echoed() && (option.traits.rivals != Rivals::end || excitation_type(settings));
  };
  return scene_of(settings, command, is_of_task)
      .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Below the answer, if the page with the program in it is installed: a link to the same task
/// there.
void link_explorer(const Settings& settings, Command command, figures::HtmlPage& page) {
  const auto explorer = report::installed_explorer();
  // The page can leave out a front, but neither cases nor a file.
  const auto is_beyond = [command](const Option& option) {
    return option.serves(command) && option.is_echoed() &&
           (option.takes_file() || option.traits.in_scene == InScene::cases);
  };
  // Of a scene for several commands k and lambda may be those of a simulation.
  const auto is_shown = [&settings](const Option& option) {
    return option.is_explored() && (settings.has("pulse") || !option.shapes(Load::pulse));
  };
  if (explorer && settings.first(is_beyond) == nullptr) {
    const std::string link =
        report::explorer_link(*explorer, scene_of(settings.over_weight(), command, is_shown));
    page.answer +=
        fmt::format("<p><a href=\"{}\">Explore this task</a></p>\n", figures::escaped(link));
  }
}

using sweep::NamedFile;

/// The files that the options with this `use` name for this command.
std::vector<NamedFile> files(Command command, const Settings& settings, FileUse use) {
  std::vector<NamedFile> files;
  for (const Option& option : options()) {
    if (option.traits.file == use && option.serves(command) && settings.has(option.name)) {
      for (std::string& path : settings.texts(option.name)) {
        files.push_back({std::string(option.name), std::move(path)});
      }
    }
  }
  return files;
}

}  // namespace

void require_no_json(const Settings& settings, std::string_view rows, std::string_view option) {
  if (settings.flag("json")) {
    throw UsageError(fmt::format("json and the {} would both go to standard output: give --{} FILE",
                                 rows, option));
  }
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
      page, {settings.text("title").value_or(""), name(command), task_of(settings, command)});
  if (command == Command::design) {
    link_explorer(settings, command, page);
  }
  if (const auto path = settings.text("html")) {
    output.write_file("html", *path, html(page));
  }
  const auto directory = settings.text("svg");
  if (!directory) {
    return;
  }
  sweep::make_directory("svg", *directory);
  for (const figures::Figure& figure : page.figures) {
    assert(figure.id.starts_with("case-") ||
           std::ranges::count(report::figure_ids(name(command)), figure.id) == 1);
    output.write_file("svg", svg_path(*directory, figure.id), svg(figure, figures::Frame::alone));
  }
}

report::SheetFrame sheet_frame(const Settings& settings, Command command) {
  return {{settings.text("title").value_or(""), name(command), task_of(settings, command)},
          settings.text("revision").value_or(""),
          report::sheet_date()};
}

void write_sheet(const Settings& settings, const std::optional<std::string>& sheet,
                 Output& output) {
  if (sheet) {
    const std::string title = settings.text("title").value_or("Damper specification");
    output.write_file("sheet", *settings.text("sheet"), figures::sheet_html(title, *sheet));
  } else {
    remark("note: no sheet is written, for there is no admissible damper");
  }
}

void remark_on(std::span<const design::Finding> findings,
               const std::optional<design::PhysicalInput>& physical) {
  for (const design::Finding& now : findings) {
    if (now.severity != design::Severity::info) {
      remark(fmt::format("{}: {}", name(now.severity), report::words(now, physical)));
    }
  }
}

std::vector<NamedFile> files_to_read(Command command, const Settings& settings,
                                     const std::optional<std::string>& scene) {
  std::vector<NamedFile> read = files(command, settings, FileUse::read);
  if (scene) {
    read.insert(read.begin(), {"scene", *scene});
  }
  std::vector<NamedFile> standard = read;
  std::erase_if(standard, [](const NamedFile& file) { return file.path != "-"; });
  if (standard.size() > 1) {
    throw UsageError(
        fmt::format("the {} and the {} cannot both be standard input: give a file for one",
                    standard[0].field, standard[1].field));
  }
  return read;
}

void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene) {
  const std::vector<NamedFile> read = files_to_read(command, settings, scene);
  std::vector<NamedFile> written = files(command, settings, FileUse::written);
  for (const auto& [option, directory] : files(command, settings, FileUse::directory)) {
    for (const std::string& figure : report::figure_ids(name(command))) {
      written.push_back({option, svg_path(directory, figure)});
    }
  }
  sweep::require_apart(read, written);
}

}  // namespace stillpoint::cli
