// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/records/record_file.hpp>

#include <algorithm>

// Acceleration records in every format: the input is the file.

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;
using namespace stillpoint::records;

/// A motion takes what is read.
void read(std::string_view text, const std::string& path, const RecordOptions& options) {
  const RecordFile file = parse_record(text, path, options);
  require_valid(Excitation(file.record));
  require(file.record.values.size() <= text.size(), "{} values of {} bytes",
          file.record.values.size(), text.size());
  RecordOptions reversed = options;
  reversed.scale = -options.scale;
  const RecordFile other = parse_record(text, path, reversed);
  require(std::ranges::equal(file.record.values, other.record.values,
                             [](double a, double b) { return a == -b; }),
          "the reverse of a record is another one");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  const RecordClock seconds{"s", 0.4, 2};
  accepted([&] { read(text, "record.AT2", {}); });
  accepted([&] { read(text, "record.txt", {.step = 0.01, .channel = 1, .clock = seconds}); });
  accepted([&] {
    read(text, "record.txt",
         {.units = RecordUnits::cm_per_s2, .channel = 2, .scale = 1e3, .clock = seconds});
  });
  return 0;
}
