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

namespace stillpoint::records {

namespace {

struct KnetHeader {
  double frequency{0};  ///< 0: not given
  std::size_t frequency_line{0};
  double duration{0};
  ValueBlock block{.count_name = "Sampling Freq times Duration Time"};
  double gal_per_count{0};
  std::size_t scale_line{0};
  std::string description;
};

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
    reader.refuse(fmt::format("{} is {}: must be a number, more than 0{}{}", key, quoted(text),
                              unit.empty() ? "" : ", in ", unit));
  }
  return scanned.value;
}

/// 3920(gal)/6182761: gal for that many counts.
double gal_per_count(const RecordReader& reader, std::string_view text) {
  const std::size_t slash = text.find('/');
  const std::string_view gal = trimmed(text.substr(0, slash));
  if (slash == std::string_view::npos || !gal.ends_with("(gal)")) {
    reader.refuse(fmt::format("Scale Factor is {}: must be A(gal)/B", quoted(text)));
  }
  return positive(reader, "Scale Factor", gal, "(gal)") /
         positive(reader, "Scale Factor", trimmed(text.substr(slash + 1)), "");
}

void note_knet_line(const RecordReader& reader, KnetHeader& header) {
  const std::string_view line = reader.line();
  const auto value_of = [line](std::string_view key) { return trimmed(line.substr(key.size())); };
  constexpr std::string_view frequency = "Sampling Freq(Hz)";
  constexpr std::string_view duration = "Duration Time(s)";
  constexpr std::string_view scale = "Scale Factor";
  if (line.starts_with(frequency)) {
    header.frequency = positive(reader, frequency, value_of(frequency), "Hz");
    header.frequency_line = reader.number();
  } else if (line.starts_with(duration)) {
    header.duration = positive(reader, duration, value_of(duration), "");
    header.block.count_line = reader.number();
  } else if (line.starts_with(scale)) {
    header.gal_per_count = gal_per_count(reader, value_of(scale));
    header.scale_line = reader.number();
  } else {
    for (const std::string_view key : {"Station Code", "Dir.", "Record Time"}) {
      if (line.starts_with(key)) {
        header.description += " " + std::string(value_of(key));
      }
    }
  }
}

KnetHeader read_knet_header(RecordReader& reader) {
  constexpr std::size_t lines = 17;
  KnetHeader header;
  while (reader.number() < lines && reader.next()) {
    note_knet_line(reader, header);
  }
  if (!reader.line().starts_with("Memo.")) {
    reader.refuse("the 17 lines of a K-NET heading must end with the line Memo.");
  }
  for (const auto& [key, value] : {std::pair{"Sampling Freq(Hz)", header.frequency},
                                   std::pair{"Duration Time(s)", header.duration},
                                   std::pair{"Scale Factor", header.gal_per_count}}) {
    if (value == 0) {
      reader.refuse(fmt::format("the heading ends here without {}", key));
    }
  }
  // 59.99 s at 100 Hz are 5999 counts, though the product of the doubles is not.
  constexpr double rounding = 1e-6;
  double count = header.frequency * header.duration;
  if (std::abs(count - std::round(count)) <= rounding) {
    count = std::round(count);
  }
  header.block.count =
      whole_count(reader, header.block.count_name, fmt::format("{:.10g}", count), count);
  return header;
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
  const KnetHeader header = read_knet_header(reader);
  const double step =
      reader.file_step(header.frequency_line, "Sampling Freq(Hz) as a step", 1 / header.frequency);
  reader.set_units(RecordUnits::cm_per_s2, header.scale_line);
  std::vector<double> values = read_block(reader, header.block, count_field);
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& value : values) {
    const auto acceleration = reader.in_g((value - mean) * header.gal_per_count);
    if (!acceleration) {
      reader.refuse(header.scale_line,
                    fmt::format("an acceleration of {} counts {}", value, reader.load_bounds()));
    }
    value = *acceleration;
  }
  const std::string description = fmt::format("{}; the mean of the counts, {:.6g}, is subtracted",
                                              single_spaced(header.description), mean);
  return {{std::move(values), step, {}},
          printable(description, longest_description),
          RecordUnits::cm_per_s2};
}

}  // namespace

constinit const RecordFormat knet_format{is_knet, read_knet};

}  // namespace stillpoint::records
