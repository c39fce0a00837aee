// SPDX-License-Identifier: MIT
#include "record_suite_input.hpp"

#include "motion_input.hpp"
#include "record_input.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace stillpoint::cli {

namespace {

constexpr std::size_t largest_list = std::size_t{1} << 20U;

struct ListedRecord {
  std::string path;
  double scale{1};
  RecordTarget target{};
};

/// A file or folder beside the list, or else from where the program runs. FILE#2 is as good.
std::string beside(const std::string& list, const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(list).parent_path();
  std::error_code unreachable;
  for (const std::string& name : {file, file.substr(0, file.rfind('#'))}) {
    if (std::filesystem::exists(folder / name, unreachable)) {
      return (folder / file).string();
    }
  }
  return file;
}

/// What the second column of a list holds.
enum class Column { scale, peak, spectrum };

Column header_column(const records::FilePlace& place, std::string_view line) {
  for (const auto& [header, column] :
       {std::pair{"file,scale", Column::scale}, std::pair{"file,peak", Column::peak},
        std::pair{"file,spectrum", Column::spectrum}}) {
    if (line == header) {
      return column;
    }
  }
  throw records::FileError(place, "must be the header file,scale, file,peak or file,spectrum");
}

/// Throws InputError.
ListedRecord listed_record(std::string path, Column column, std::string_view text) {
  if (column == Column::scale) {
    const double scale = parse_number("scale", text);
    if (scale == 0) {
      throw InputError("scale", 0, "must not be 0");
    }
    return {std::move(path), scale};
  }
  const char* const name = column == Column::peak ? "peak" : "spectrum";
  const double value = records::parse_value(name, Dimension::gravities, text);
  require_within(name, value, smallest_physical, largest_physical);
  return {std::move(path), 1,
          column == Column::peak ? RecordTarget{value, {}} : RecordTarget{{}, value}};
}

std::vector<ListedRecord> listed_records(const std::string& path) {
  const std::string text = records::read_text_file("records-list", path, largest_list);
  std::vector<ListedRecord> list;
  Column column = Column::scale;
  std::size_t number = 0;
  for (std::string_view line : records::split(text, '\n')) {
    ++number;
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    const records::FilePlace place{"records-list", path, number};
    if (number == 1) {
      column = header_column(place, line);
      continue;
    }
    if (line.empty() || line.starts_with('#')) {
      continue;
    }
    const std::size_t comma = line.rfind(',');
    if (comma == std::string::npos || comma == 0) {
      throw records::FileError(
          place, fmt::format("must be FILE,{}", column == Column::scale ? "SCALE" : "TARGET"));
    }
    try {
      list.push_back(listed_record(beside(path, std::string(line.substr(0, comma))), column,
                                   line.substr(comma + 1)));
    } catch (const InputError& error) {
      throw records::FileError(place, error.what());
    }
  }
  if (list.empty()) {
    throw records::FileError({"records-list", path}, "has no record");
  }
  return list;
}

std::vector<ListedRecord> asked_records(const Settings& settings) {
  std::vector<std::string> paths = settings.texts("record");
  std::vector<ListedRecord> asked;
  asked.reserve(paths.size());
  for (std::string& path : paths) {
    asked.push_back({std::move(path)});
  }
  const RecordTarget target = record_target(settings);
  if (const auto path = settings.text("records-list")) {
    for (ListedRecord& listed : listed_records(*path)) {
      if (target.is_given() && listed.target.is_given()) {
        throw UsageError(fmt::format("{} and the targets in {} exclude each other",
                                     target.peak ? "record-peak" : "record-spectrum", *path));
      }
      asked.push_back(std::move(listed));
    }
  }
  std::vector<ListedRecord> files;
  for (ListedRecord& record : asked) {
    if (target.is_given()) {
      record.target = target;
    }
    for (std::string& file : records::record_files(record.path)) {
      files.push_back({std::move(file), record.scale, record.target});
    }
  }
  return files;
}

}  // namespace

std::vector<design::SuiteRecord> read_suite(const Settings& settings,
                                            const records::RecordClock& clock,
                                            std::optional<double> p) {
  const records::RecordOptions options = record_options(settings, clock);
  const RecordScaling scaling(settings, clock, p);
  const double scale_of_all = settings.number("record-scale").value_or(1);
  records::require_scale(scale_of_all);
  const std::vector<ListedRecord> asked = asked_records(settings);
  std::vector<design::SuiteRecord> suite;
  suite.reserve(asked.size());
  for (const auto& [path, scale, target] : asked) {
    Record record = records::read_record(path, options).record;
    const double factor = scale_of_all * scale * scaling.factor(record, path, target);
    suite.push_back({path, std::move(record), factor});
  }
  return suite;
}

}  // namespace stillpoint::cli
