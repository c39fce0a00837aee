// SPDX-License-Identifier: MIT

// The ASCII files of K-NET and KiK-net: 17 lines of heading, the last one "Memo.", then counts,
// eight a line. An acceleration in gal is the count less the mean of all counts, times the scale
// factor: the counts carry the offset of the recorder, and the instrument's own peak ("Max. Acc.")
// is given without it.

#include "channel.hpp"
#include "value_block.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace stillpoint::records {

namespace {

bool is_knet(RecordReader reader) {
  return reader.next() && reader.line().starts_with("Origin Time");
}

/// The number in front of `unit`, which may be left out; more than 0.
double positive(const RecordReader& reader, std::string_view key, std::string_view text,
                std::string_view unit) {
  const std::string_view digits =
      trimmed(text.ends_with(unit) ? text.substr(0, text.size() - unit.size()) : text);
  const ScannedNumber scanned = scan_fortran_number(digits);
  if (scanned.fault != NumberFault::none || !(scanned.value > 0)) {
    reader.refuse(fmt::format("{} is {}: must be a number, more than 0{}{}{}", key, quoted(text),
                              unit.empty() ? "" : ", in ", unit, comma_note(text)));
  }
  return scanned.value;
}

/// 3920(gal)/6182761: gal for that many counts.
double gal_per_count(const HeaderText& scale) {
  const auto& [text, reader] = scale;
  const std::size_t slash = text.find('/');
  const std::string_view gal = trimmed(text.substr(0, slash));
  if (slash == std::string_view::npos || !gal.ends_with("(gal)")) {
    reader.refuse(fmt::format("Scale Factor is {}: must be A(gal)/B", quoted(text)));
  }
  return positive(reader, "Scale Factor", gal, "(gal)") /
         positive(reader, "Scale Factor", trimmed(text.substr(slash + 1)), "");
}

std::vector<RecordReader> read_knet_header(RecordReader& reader) {
  constexpr std::size_t lines = 17;
  std::vector<RecordReader> header;
  while (reader.number() < lines && reader.next()) {
    header.push_back(reader);
  }
  if (!reader.line().starts_with("Memo.")) {
    reader.refuse("the 17 lines of a K-NET heading must end with the line Memo.");
  }
  return header;
}

ValueBlock counts_below(const HeaderText& duration, double frequency) {
  constexpr std::string_view name = "Sampling Freq times Duration Time";
  // 59.99 s at 100 Hz are 5999 counts, though the product of the doubles is not.
  constexpr double rounding = 1e-6;
  double count = frequency * positive(duration.reader, "Duration Time(s)", duration.text, "");
  if (std::abs(count - std::round(count)) <= rounding) {
    count = std::round(count);
  }
  return {std::string(name),
          whole_count(duration.reader, name, fmt::format("{:.10g}", count), count),
          duration.reader.number()};
}

double count_field(const RecordReader& reader, std::string_view field) {
  constexpr double largest = 0x1p31;  // the recorders have 24 bits; the sum of all stays exact
  const double count = reader.parse_number(field);
  if (count != std::floor(count) || std::abs(count) > largest) {
    reader.refuse_word(field, "is not a count: must be a whole number of at most 32 bits");
  }
  return count;
}

RecordFile read_knet(RecordReader& reader) {
  const std::vector<RecordReader> header = read_knet_header(reader);
  const auto [rate, rate_line] = text_of(header, "Sampling Freq(Hz)");
  const double frequency = positive(rate_line, "Sampling Freq(Hz)", rate, "Hz");
  const double step =
      reader.file_step(rate_line.number(), "Sampling Freq(Hz) as a step", 1 / frequency);
  const ValueBlock block = counts_below(text_of(header, "Duration Time(s)"), frequency);
  const HeaderText scale = text_of(header, "Scale Factor");
  const double gal = gal_per_count(scale);
  reader.set_units(RecordUnits::cm_per_s2, scale.reader.number());
  std::vector<double> values = read_block(reader, block, count_field);
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& value : values) {
    const auto acceleration = reader.in_g((value - mean) * gal);
    if (!acceleration) {
      scale.reader.refuse(
          fmt::format("an acceleration of {} counts {}", value, reader.load_bounds()));
    }
    value = *acceleration;
  }
  const std::string description =
      fmt::format("{}; the mean of the counts, {:.6g}, is subtracted",
                  described(header, {"Station Code", "Record Time", "Dir."}), mean);
  return {{std::move(values), step, {}},
          printable(description, longest_description),
          RecordUnits::cm_per_s2};
}

}  // namespace

// .UD, the vertical component, is left out: the mass moves sideways.
constinit const RecordFormat knet_format{"K-NET", ".EW .NS .EW1 .NS1 .EW2 .NS2", is_knet,
                                         read_knet};

}  // namespace stillpoint::records
