// SPDX-License-Identifier: MIT

// The corrected records (volume 2, .V2) of the California networks, CSMIP, earlier CGS and CDMG:
// for each channel 25 lines of text, 100 whole numbers and 100 reals, then blocks of acceleration,
// velocity and displacement. The line above each block gives everything needed:
//
//     2000 points of accel data equally spaced at  .020 sec, in cm/sec2. (8f10.3)

#include "acceleration_units.hpp"
#include "channel.hpp"
#include "value_block.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

namespace stillpoint::records {

namespace {

bool begins_csmip_channel(std::string_view line) {
  return upper_case(line).find("POINTS OF ACCEL") != std::string::npos;
}

bool is_csmip(RecordReader reader) {
  return reader.next() && upper_case(trimmed(reader.line())).starts_with("CORRECTED ACCELEROGRAM");
}

/// What the line above the values says; a few leave out the units.
struct CsmipLine {
  std::string_view count;
  std::string_view step;
  std::string_view units;
};

/// "... at .02 sec, in cm/sec2. (8f10.3)", or "... at .02 sec. (UNITS: CM/SEC/SEC)".
CsmipLine csmip_line(const RecordReader& reader) {
  const auto words = words_of(reader.line(), " \t()");
  CsmipLine line{words[0], {}, {}};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string word = upper_case(words[i]);
    if (word == "AT" && i + 2 < words.size() && upper_case(words[i + 2]).starts_with("SEC")) {
      line.step = words[i + 1];
    } else if (word == "IN" || word == "UNITS:") {
      line.units = words[i + 1];
    }
  }
  line.units = line.units.substr(0, line.units.find_last_not_of(".,") + 1);
  constexpr std::string_view example =
      "as in 100 points of accel data equally spaced at .02 sec, in cm/sec2";
  if (line.step.empty()) {
    reader.refuse(fmt::format("the step is missing, {}", example));
  }
  if (line.units.empty() && !reader.options().units) {
    reader.refuse(fmt::format("the units are missing, {}: give record-units", example));
  }
  return line;
}

/// The University of Southern California has the same title, a number in columns 73 and 74 of the
/// lines below it, and no line above its values that says what they are.
void refuse_usc(RecordReader reader) {
  constexpr std::size_t last = 12;
  std::size_t numbered = 0;
  bool says = false;
  while (reader.next() && !says) {
    says = begins_csmip_channel(reader.line());
    const std::string_view line = reader.line();
    numbered +=
        reader.number() <= last && line.size() > 72 && is_number(trimmed(line.substr(72, 2))) ? 1U
                                                                                              : 0U;
  }
  if (!says && numbered > last / 2) {
    reader.refuse(1, "is a volume 2 of USC, which is not read: most of its records are at PEER");
  }
}

RecordFile read_csmip(RecordReader& reader) {
  refuse_usc(reader);
  const RecordReader start = reader;
  go_to_channel(reader, begins_csmip_channel);
  const auto [count, step, given] = csmip_line(reader);
  const RecordUnits units = given.empty() ? *reader.options().units : read_units(reader, given);
  return read_described(reader, {"the count of points", {count, reader}}, {"step", {step, reader}},
                        units, reader.number(), {.width = field_width(reader.line())},
                        described(start, reader, "Station No", "Chan"));
}

}  // namespace

constinit const RecordFormat csmip_format{"CSMIP", ".V2", is_csmip, read_csmip, true};

}  // namespace stillpoint::records
