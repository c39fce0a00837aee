// SPDX-License-Identifier: MIT
#include "input/record_suite.hpp"

#include "input/motion.hpp"
#include "input/record.hpp"

#include <stillpoint/records/record_list.hpp>
#include <stillpoint/records/record_scaling.hpp>

#include <fmt/format.h>

#include <utility>

namespace stillpoint::cli {

namespace {

std::vector<records::ListedRecord> asked_records(const Settings& settings) {
  std::vector<std::string> paths = settings.texts("record");
  std::vector<records::ListedRecord> asked;
  asked.reserve(paths.size());
  for (std::string& path : paths) {
    asked.push_back({std::move(path)});
  }
  const records::RecordTarget target = record_target(settings);
  if (const auto path = settings.text("records-list")) {
    for (records::ListedRecord& listed : records::read_record_list(*path)) {
      if (target.is_given() && listed.target.is_given()) {
        throw UsageError(fmt::format("{} and the targets in {} exclude each other",
                                     target.peak ? "record-peak" : "record-spectrum", *path));
      }
      asked.push_back(std::move(listed));
    }
  }
  std::vector<records::ListedRecord> files;
  for (records::ListedRecord& record : asked) {
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
  const std::vector<records::ListedRecord> asked = asked_records(settings);
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
