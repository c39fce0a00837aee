// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

#include <utility>

namespace stillpoint::records {

std::vector<ListedRecord> asked_records(const SuiteFiles& files, const RecordTarget& of_all) {
  std::vector<ListedRecord> asked;
  asked.reserve(files.paths.size());
  for (const std::string& path : files.paths) {
    asked.push_back({path, 1, of_all});
  }
  if (!files.list) {
    return asked;
  }
  for (ListedRecord& listed : read_record_list(*files.list)) {
    if (of_all.is_given() && listed.target.is_given()) {
      throw FileError({"records-list", *files.list},
                      fmt::format("its targets and {} cannot be combined",
                                  of_all.peak ? "record-peak" : "record-spectrum"));
    }
    if (of_all.is_given()) {
      listed.target = of_all;
    }
    asked.push_back(std::move(listed));
  }
  return asked;
}

std::vector<SuiteRecord> read_suite(const SuiteFiles& files, const RecordScale& scale,
                                    const RecordOptions& options) {
  require_scale(scale.factor);
  RecordOptions of_each = options;
  of_each.step_for_others = true;
  bool step_serves = !options.step;
  std::vector<SuiteRecord> suite;
  for (const ListedRecord& asked : asked_records(files, scale.target)) {
    const RecordScale to{scale.factor * asked.scale, asked.target, scale.spectrum_p};
    for (std::string& file : record_files(asked.path)) {
      RecordFile read = read_record(file, of_each);
      step_serves = step_serves || read.takes_step;
      const double factor = to.factor * factor_to_target(to, read.record, file, options.clock);
      suite.push_back(
          {std::move(file), std::move(read.record), factor, read.units, read.assumed_g});
    }
  }
  if (!step_serves) {
    throw InputError("record-step", fmt::format("{} {}", *options.step, options.clock.unit),
                     "must not be given: each record has times or a step of its own");
  }
  return suite;
}

}  // namespace stillpoint::records
