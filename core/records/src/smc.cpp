// SPDX-License-Identifier: MIT

// The SMC format of the U.S. Geological Survey: 11 lines of text, 48 whole numbers in fields of 10
// columns, 50 reals in fields of 15, comments, then values in cm/s2 in fields of 10, which may
// touch. Whole number 16 counts the lines of comments and number 17 the values; the second real is
// the number of samples in a second.

#include "channel.hpp"
#include "value_block.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace stillpoint::records {

namespace {

constexpr std::string_view smc_kinds = "1 UNCORRECTED ACCELEROGRAM and 2 CORRECTED ACCELEROGRAM";

/// "2 CORRECTED ACCELEROGRAM"; a velocity, a spectrum and the like as well, to be refused.
bool is_smc(RecordReader reader) {
  constexpr std::array kinds{"1 UNCORRECTED ACCELEROGRAM",
                             "2 CORRECTED ACCELEROGRAM",
                             "3 VELOCITY",
                             "4 DISPLACEMENT",
                             "5 RESPONSE SPECTRA",
                             "6 FOURIER"};
  if (!reader.next()) {
    return false;
  }
  const std::string first = upper_case(single_spaced(reader.line()));
  return std::ranges::any_of(kinds, [&](const char* kind) { return first.starts_with(kind); });
}

RecordFile read_smc(RecordReader& reader) {
  constexpr std::size_t titles = 11;
  constexpr std::size_t integer_lines = 6;
  constexpr std::size_t integer_width = 10;
  constexpr std::size_t real_lines = 10;
  constexpr std::size_t real_width = 15;
  constexpr std::size_t value_width = 10;
  skip(reader, 1);
  if (upper_case(reader.line()).find("ACCELEROGRAM") == std::string::npos) {
    reader.refuse(fmt::format("{} is not an acceleration: {} are read",
                              quoted(trimmed(reader.line())), smc_kinds));
  }
  std::string description;
  for (std::size_t line = 2; line <= titles; ++line) {
    skip(reader, 1);
    if (line <= 6) {
      const std::string title = single_spaced(reader.line());
      if (!title.empty() && title != "*") {
        description += (description.empty() ? "" : "; ") + title;
      }
    }
  }
  const HeaderText comments = header_number(reader, integer_lines, integer_width, 16);
  const HeaderText count = header_number(reader, integer_lines, integer_width, 17);
  skip(reader, integer_lines);
  const HeaderText rate = header_number(reader, real_lines, real_width, 2);
  constexpr double unknown = 1e38;  // the format writes 1.7E+38
  if (!(value_of(rate) > 0 && value_of(rate) < unknown)) {
    rate.reader.refuse(
        fmt::format("real number 2, the samples in a second, is {}: must be more "
                    "than 0 and known",
                    rate.text));
  }
  skip(reader, real_lines);
  if (value_of(comments) > 0) {
    skip(reader, whole_count(comments.reader, "whole number 16, the lines of comments,",
                             comments.text, value_of(comments)));
  }
  return read_described(reader, {"whole number 17, the count of values,", count},
                        {"1 over the samples in a second", rate, 1 / value_of(rate)},
                        RecordUnits::cm_per_s2, 1, {.width = value_width}, description);
}

}  // namespace

constinit const RecordFormat smc_format{"SMC", ".SMC", is_smc, read_smc};

}  // namespace stillpoint::records
