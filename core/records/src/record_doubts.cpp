// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace stillpoint::records {

namespace {

/// In g, of values whose units are assumed. Few ground motions have a larger peak, and any in m/s2
/// that is dangerous has.
constexpr double doubtful_peak = 2;
/// Hardly any that was recorded is larger.
constexpr double absurd_peak = 3;
/// Codes allow about as much: beyond it the shaking of another kind of earthquake is needed.
constexpr double doubtful_factor = 4;
/// Of values that are in m/s2 rather than in cm/s2.
constexpr double largest_in_m_per_s2 = 20;

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

/// Of units, scale and peak; "" if they are usual.
std::string strength_doubt(const RecordFile& file, double peak, double factor, bool has_target) {
  if (std::abs(factor) > doubtful_factor) {
    return fmt::format(
        "is multiplied by {:.4g}, to a peak of {:.4g} g; more than {} is doubtful: take a stronger "
        "record",
        factor, peak * std::abs(factor), doubtful_factor);
  }
  if (file.assumed_g && !has_target && peak > doubtful_peak) {
    return fmt::format(
        "the largest value is {:.4g} g if its values are in g, which is assumed; did you mean "
        "--record-units {}?",
        peak, peak < largest_in_m_per_s2 ? "m/s2" : "cm/s2");
  }
  return peak * std::abs(factor) > absurd_peak
             ? fmt::format(
                   "has a peak of {:.4g} g; more than {} g is doubtful, for few ground "
                   "motions exceed {} g",
                   peak * std::abs(factor), absurd_peak, doubtful_peak)
             : "";
}

/// Of the values by themselves.
std::string shape_doubt(const Record& record, double peak) {
  constexpr std::size_t few = 20;
  constexpr double strong = 0.25;         // of the peak: a record dies away
  constexpr std::size_t end = 20;         // the last of so many parts, which a crossing of 0 is not
  constexpr double offset = 0.01;         // of the peak: the ground comes to rest
  constexpr double least_offset = 0.004;  // g, which makes 1 m/s in half a minute
  const std::vector<double>& values = record.values;
  const auto [least, most] = std::ranges::minmax(values);
  if (values.size() >= few && (least > 0 || most < 0)) {
    return "has values of one sign only: is it a spectrum, not an acceleration?";
  }
  if (values.size() < enough_values) {
    return "";
  }
  const auto [low, high] = std::ranges::minmax(std::span(values).last(values.size() / end));
  if (const double last = std::max(-low, high); last > strong * peak) {
    return fmt::format("has {:.4g} g at its end, where its peak is {:.4g} g: is it cut off?", last,
                       peak);
  }
  const double mean = mean_value(record);
  return std::abs(mean) > std::max(offset * peak, least_offset)
             ? fmt::format("has the mean {:.4g} g: was the offset of the recorder not removed?",
                           mean)
             : "";
}

/// "UP", "V" and the like at the end of a file's name or description, or behind a channel's number.
bool is_vertical(const std::string& path, std::string_view description) {
  constexpr std::array<std::string_view, 11> words{"UP",   "DOWN",     "DWN", "DN", "V",  "VER",
                                                   "VERT", "VERTICAL", "Z",   "UD", "U-D"};
  const auto names_it = [&](std::string_view word) {
    const bool is_stream = word.size() == 3 && word[2] == 'Z' &&
                           std::string_view("NGL").find(word[1]) != std::string_view::npos;
    return is_stream || std::ranges::count(words, word) > 0;
  };
  const std::string name = upper_case(std::filesystem::path(path).stem().string());
  const std::string text = upper_case(description);
  const auto of_name = words_of(name, "-_. ");
  const auto of_text = words_of(text, " ,;:()/+");
  bool found = !of_name.empty() && names_it(of_name.back());
  for (std::size_t i = 0; i < of_text.size(); ++i) {
    const bool is_last = i + 1 == of_text.size();
    const bool is_numbered =
        i > 0 && of_text[i - 1].find_first_not_of("0123456789") == std::string_view::npos;
    found = found || of_text[i] == "U-D" || (is_last && of_text[i] == "U") ||
            (names_it(of_text[i]) && (is_last || is_numbered));
  }
  return found;
}

void add_doubts(const RecordFile& file, const std::string& path, const RecordScale& scale,
                const RecordOptions& options, std::vector<std::string>& doubts) {
  const Record& record = file.record;
  const double peak = peak_acceleration(record);
  const bool is_known = !scale.target.spectrum || scale.spectrum_p;
  const double factor =
      scale.factor * (is_known ? factor_to_target(scale, record, path, options.clock) : 1);
  const auto say = [&](std::string_view message) {
    if (!message.empty()) {
      doubts.emplace_back(FileError({"record", path}, message).what());
    }
  };
  say(file.doubt);
  say(is_vertical(path, file.description)
          ? "is a vertical component by its name, but the mass moves sideways"
          : "");
  say(strength_doubt(file, peak, factor, scale.target.is_given()));
  say(shape_doubt(record, peak));
  if (const double step = mean_interval(record).value_or(0);
      step > doubtful_step && record.values.size() >= enough_values) {
    say(fmt::format("its values are {:.4g} s apart on average; are its times in ms?", step));
  }
  const std::vector<double>& times = record.times;
  if (const auto i = long_step(times)) {
    say(
        fmt::format("the time jumps from {:.6g} to {:.6g}, though other steps are {:.6g}: values "
                    "may be missing; W is linear between",
                    times[*i - 1], times[*i], times[1] - times[0]));
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
      doubts.emplace_back(
          FileError({"record", file}, "is left out because it begins with text").what());
    }
    for (const std::string& file : record_files(asked.path)) {
      add_doubts(read_record(file, of_each), file,
                 {scale.factor * asked.scale, asked.target, scale.spectrum_p}, options, doubts);
    }
  }
  return doubts;
}

}  // namespace stillpoint::records
