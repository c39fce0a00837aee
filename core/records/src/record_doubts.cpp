// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace stillpoint::records {

namespace {

/// In g. Few ground motions have a larger peak, and any in m/s2 that is dangerous has.
constexpr double doubtful_peak = 2;
/// To which no record is scaled.
constexpr double absurd_peak = 20;
/// Of values that are in m/s2 rather than in cm/s2.
constexpr double largest_in_m_per_s2 = 20;

std::string doubt(const std::string& path, std::string_view message) {
  return FileError({"record", path}, message).what();
}

/// In s; a record of a hundred values has a shorter step, unless its times are in ms.
constexpr double doubtful_step = 1;
constexpr std::size_t enough_values = 100;

/// A step that is several times as long as the first one, where nearly all are like that.
std::optional<std::size_t> long_step(const std::vector<double>& times) {
  constexpr double far = 5;
  constexpr double alike = 0.1;          // of a step: times may be rounded to few digits
  constexpr std::size_t one_other = 10;  // one step in as many may be another
  std::optional<std::size_t> found;
  std::size_t others = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double first = times[1] - times[0];
    const double step = times[i] - times[i - 1];
    others += std::abs(step - first) > alike * first ? 1U : 0U;
    found = step > far * first ? i : found;
  }
  return one_other * others < times.size() ? found : std::nullopt;
}

void add_doubts(const RecordFile& file, const std::string& path, const RecordTarget& target,
                double scale, std::vector<std::string>& doubts) {
  const double peak = peak_acceleration(file.record);
  const double scaled = target.peak.value_or(target.spectrum.value_or(peak * std::abs(scale)));
  if ((target.is_given() || scale != 1) && scaled > absurd_peak) {
    doubts.push_back(
        doubt(path, fmt::format("is scaled to {:.4g} g; more than {} g is doubtful, for few ground "
                                "motions exceed {} g",
                                scaled, absurd_peak, doubtful_peak)));
  } else if (file.assumed_g && !target.is_given() && peak > doubtful_peak) {
    doubts.push_back(
        doubt(path, fmt::format("the largest value is {:.4g} g if its values are in g, which "
                                "is assumed; did you mean --record-units {}?",
                                peak, peak < largest_in_m_per_s2 ? "m/s2" : "cm/s2")));
  }
  if (const double step = mean_interval(file.record).value_or(0);
      step > doubtful_step && file.record.values.size() >= enough_values) {
    doubts.push_back(doubt(
        path, fmt::format("its values are {:.4g} s apart on average; are its times in ms?", step)));
  }
  const std::vector<double>& times = file.record.times;
  if (const auto i = long_step(times)) {
    doubts.push_back(
        doubt(path, fmt::format("the time jumps from {:.6g} to {:.6g}, though other steps "
                                "are {:.6g}: values may be missing; W is linear between",
                                times[*i - 1], times[*i], times[1] - times[0])));
  }
}

}  // namespace

std::vector<std::string> suite_doubts(const SuiteFiles& files, const RecordScale& scale,
                                      const RecordOptions& options) {
  RecordOptions of_each = options;
  of_each.step_for_others = true;
  std::vector<std::string> doubts;
  for (const ListedRecord& asked : asked_records(files, scale.target)) {
    for (const std::string& file : folder_files(asked.path).plain_text) {
      doubts.push_back(doubt(file, "is left out because it begins with text"));
    }
    for (const std::string& file : record_files(asked.path)) {
      add_doubts(read_record(file, of_each), file, asked.target, scale.factor * asked.scale,
                 doubts);
    }
  }
  return doubts;
}

}  // namespace stillpoint::records
