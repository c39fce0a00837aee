// SPDX-License-Identifier: MIT
#include "written_files.hpp"

#include "pages.hpp"

#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace stillpoint::cli {

namespace {

using sweep::is_special_file;
using sweep::is_standard_output;
using sweep::same_file;

struct NamedFile {
  std::string field;
  std::string path;
};

std::string shown(const NamedFile& file) {
  return fmt::format("{} {}", file.field, file.path == "-" ? "on standard input" : file.path);
}

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
    all.push_back({"output", *output + ".part"});
    all.push_back({"output", *output + ".part.json"});
  }
  for (const auto& [option, directory] : files(command, settings, FileUse::directory)) {
    for (const std::string_view figure : figure_names(command)) {
      all.push_back({option, svg_path(directory, figure)});
    }
  }
  return all;
}

/// What cannot be a name is refused where the file is written.
bool may_be_a_file(const std::string& path) {
  return !path.empty() && path != "-" && !is_special_file(path);
}

/// A sweep that is alive writes FILE.part, and FILE.part.json beside it.
void refuse_part_of_a_sweep(const NamedFile& file) {
  if (sweep::is_being_swept(file.path)) {
    throw UsageError(
        fmt::format("{}: a sweep is writing it: let it end, or give another file", shown(file)));
  }
}

}  // namespace

void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene) {
  const std::vector<NamedFile> inputs = read_files(command, settings, scene);
  const std::vector<NamedFile> outputs = written_files(command, settings);
  std::ranges::for_each(files(command, settings, FileUse::written), refuse_part_of_a_sweep);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    if (!may_be_a_file(output.path)) {
      continue;
    }
    for (const NamedFile& input : inputs) {
      if (same_file(input.path == "-" ? "/dev/stdin" : input.path, output.path)) {
        throw UsageError(fmt::format("{} would overwrite the {}: give another file", shown(output),
                                     shown(input)));
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      const NamedFile& other = outputs[j];
      const bool both_standard = is_standard_output(other.path) && is_standard_output(output.path);
      if (may_be_a_file(other.path) && !both_standard && same_file(other.path, output.path)) {
        throw UsageError(
            fmt::format("{} and {} are the same file: give two", shown(other), shown(output)));
      }
    }
  }
}

}  // namespace stillpoint::cli
