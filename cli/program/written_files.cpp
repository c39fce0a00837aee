// SPDX-License-Identifier: MIT
#include "written_files.hpp"

#include "output.hpp"

#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace stillpoint::cli {

namespace {

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
