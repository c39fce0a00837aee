// SPDX-License-Identifier: MIT
#include "written_files.hpp"

#include "output.hpp"

#include <stillpoint/sweep/files_apart.hpp>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace stillpoint::cli {

namespace {

using sweep::NamedFile;

/// What the options that `use` a file name for this command.
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

std::vector<NamedFile> read_files(Command command, const Settings& settings,
                                  const std::optional<std::string>& scene) {
  std::vector<NamedFile> all = files(command, settings, FileUse::read);
  if (scene) {
    all.insert(all.begin(), {"scene", *scene});
  }
  return all;
}

std::vector<NamedFile> written_files(Command command, const Settings& settings) {
  std::vector<NamedFile> all = files(command, settings, FileUse::written);
  const auto output = settings.text("output");
  if (command == Command::sweep && output) {
    std::ranges::copy(sweep::part_files({"output", *output}), std::back_inserter(all));
  }
  for (const auto& [option, directory] : files(command, settings, FileUse::directory)) {
    for (const std::string_view figure : figure_names(command)) {
      all.push_back({option, svg_path(directory, figure)});
    }
  }
  return all;
}

}  // namespace

void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene) {
  std::ranges::for_each(files(command, settings, FileUse::written), sweep::require_not_swept);
  sweep::require_apart(read_files(command, settings, scene), written_files(command, settings));
}

}  // namespace stillpoint::cli
