// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <utility>

namespace stillpoint::records {

namespace {

/// In g. Few ground motions have a larger peak, and any in m/s2 that is dangerous has.
constexpr double doubtful_peak = 2;
/// Of values that are in m/s2 rather than in cm/s2.
constexpr double largest_in_m_per_s2 = 20;

std::string doubt(FilePlace place, std::string_view message) {
  return FileError(std::move(place), message).what();
}

void add_doubts(const RecordFile& file, const std::string& path, bool is_scaled,
                std::vector<std::string>& doubts) {
  const double peak = peak_acceleration(file.record);
  if (file.assumed_g && !is_scaled && peak > doubtful_peak) {
    doubts.push_back(doubt(
        {"record", path}, fmt::format("the largest value is {:.4g} g if its values are in g, which "
                                      "is assumed; did you mean --record-units {}?",
                                      peak, peak < largest_in_m_per_s2 ? "m/s2" : "cm/s2")));
  }
  if (const auto& jump = file.jump) {
    doubts.push_back(doubt({"record", path, jump->line},
                           fmt::format("the time jumps from {} to {}, though other steps are {}: "
                                       "values may be missing; W is linear between these two",
                                       jump->from, jump->to, jump->step)));
  }
}

}  // namespace

std::vector<std::string> suite_doubts(const SuiteFiles& files, const RecordTarget& of_all,
                                      const RecordOptions& options) {
  std::vector<std::string> doubts;
  for (const ListedRecord& asked : asked_records(files, of_all)) {
    for (const std::string& file : folder_files(asked.path).plain_text) {
      doubts.push_back(doubt({"record", file}, "is left out because it begins with text"));
    }
    for (const std::string& file : record_files(asked.path)) {
      add_doubts(read_record(file, options), file, asked.target.is_given(), doubts);
    }
  }
  return doubts;
}

}  // namespace stillpoint::records
