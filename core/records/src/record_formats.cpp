// SPDX-License-Identifier: MIT
#include "record_reader.hpp"
#include "value_block.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

namespace stillpoint::records {

namespace {

constexpr std::array formats{&at2_format,   &esm_format,    &knet_format,   &geonet_format,
                             &csmip_format, &cosmos_format, &smc_format,    &nsmn_format,
                             &cwb_format,   &asa_format,    &columns_format};

/// A scale beyond these is a mistake; products would lose digits or leave the range of a double.
constexpr double smallest_scale = 1e-100;
constexpr double largest_scale = 1e100;

/// The first that recognises the file. PEER, which may do so late in a header, is asked after the
/// others but the columns, which take any file.
const RecordFormat& format_of(const RecordReader& reader) {
  const auto recognises = [&](const RecordFormat* each) { return each->recognises(reader); };
  const auto* const columns = formats.end() - 1;
  const auto* const found = std::find_if(formats.begin() + 1, columns, recognises);
  return **(found == columns && recognises(formats.front()) ? formats.begin() : found);
}

void check(const RecordOptions& options) {
  if (options.step && !options.clock.holds_step(*options.step)) {
    throw InputError("record-step", fmt::format("{} {}", *options.step, options.clock.unit),
                     step_bounds(options.clock));
  }
  require_scale(options.scale);
  require_within("gravity", options.gravity_m_per_s2, smallest_scale, largest_scale);
}

/// FILE of FILE#2, whose number goes into `channel`.
std::string without_channel(const std::string& path, std::optional<std::size_t>& channel) {
  const std::size_t sign = path.rfind('#');
  std::error_code unreachable;
  if (sign == std::string::npos || std::filesystem::exists(path, unreachable)) {
    return path;
  }
  std::size_t number = 0;
  const char* const end = path.data() + path.size();
  const auto [stop, error] = std::from_chars(path.data() + sign + 1, end, number);
  if (error != std::errc() || stop != end || number == 0) {
    return path;
  }
  channel = number;
  return path.substr(0, sign);
}

}  // namespace

std::span<const RecordFormat* const> record_formats() {
  return formats;
}

std::vector<std::string_view> record_format_names() {
  std::vector<std::string_view> names(formats.size());
  std::ranges::transform(formats, names.begin(),
                         [](const RecordFormat* each) { return each->name; });
  return names;
}

void require_scale(double scale) {
  if (!(std::abs(scale) >= smallest_scale && std::abs(scale) <= largest_scale)) {
    throw InputError(
        "record-scale", scale,
        fmt::format("must have a magnitude from {} to {}", smallest_scale, largest_scale));
  }
}

RecordFile parse_record(std::string_view text, const std::string& path,
                        const RecordOptions& options) {
  check(options);
  if (const std::string_view unread = unread_format(text); !unread.empty()) {
    throw FileError({"record", path}, unread);
  }
  RecordReader reader(text, path, options);
  const RecordFormat& format = format_of(reader);
  if (options.channel.value_or(1) > 1 && !format.has_channels) {
    throw FileError({"record", path},
                    fmt::format("holds one record, so there is no channel {}", *options.channel));
  }
  return format.read(reader);
}

bool is_plain_text(std::string_view text, const std::string& path) {
  constexpr int headings = 1;  // above columns: a record, which needs a # there
  const RecordOptions options;
  if (!unread_format(text).empty()) {
    return false;
  }
  RecordReader reader(text, path, options);
  if (&format_of(reader) != &columns_format) {
    return false;
  }
  for (int lines = 0; lines <= headings && reader.next();) {
    const auto words = words_of(reader.line().substr(0, reader.line().find('#')), " \t,;");
    if (!words.empty()) {
      if (is_number(words.front())) {
        return false;
      }
      ++lines;
    }
  }
  return true;
}

RecordFile read_record(const std::string& path, const RecordOptions& options) {
  check(options);
  if (options.held && options.held->contains(path)) {
    return parse_record(options.held->at(path), path, options);
  }
  RecordOptions chosen = options;
  const std::string file = without_channel(path, chosen.channel);
  return parse_record(read_text_file("record", file, largest_record_bytes), file, chosen);
}

}  // namespace stillpoint::records
