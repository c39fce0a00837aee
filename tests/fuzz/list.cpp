// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/record_suite.hpp>
#include <stillpoint/sweep/catalogue_file.hpp>
#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/units.hpp>

#include <vector>

// Files with an entry on each line: lists of a sweep, catalogues of parts, lists of records. The
// input is the file, and each reader gets it.

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;
using namespace stillpoint::sweep;

void read_entries(const std::string& path, const std::optional<SweepUnits>& units) {
  List list(path, units);
  std::vector<double> values;
  std::int64_t entries = 0;
  while (list.next(values)) {
    ++entries;
    require(values.size() == list.columns().size(), "{} values of {} columns", values.size(),
            list.columns().size());
    for (const double value : values) {
      require(std::isfinite(value), "the value {} on line {}", value, list.line());
    }
  }
  List again(path, units);
  require(read_to_end(again).entries == entries, "{} entries at first", entries);
}

void read_parts(const std::string& path, const CatalogueUnits& units) {
  for (const design::Part& part : read_catalogue(path, units)) {
    require(
        !part.name.empty() && part.f >= 0 && part.delta >= 0 && std::isfinite(part.f + part.delta),
        "part {}: f = {}, delta = {}", part.name, part.f, part.delta);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MemoryFile file;
  file.hold(text_of(data, size));
  const std::string path = file.path();
  const auto metres = [](std::string_view text) { return records::parse_number("delta-m", text); };
  accepted([&] { read_entries(path, {}); });
  accepted([&] { read_entries(path, SweepUnits()); });
  accepted([&] { read_parts(path, {.p = 2, .parse_metres = metres}); });
  accepted([&] { read_parts(path, {.length_m = 0.2, .parse_metres = metres}); });
  accepted([&] {
    for (const records::ListedRecord& record : records::read_record_list(path)) {
      require(record.scale != 0 && std::isfinite(record.scale), "the scale {}", record.scale);
    }
  });
  return 0;
}
