// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/part.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace stillpoint::sweep {

std::string text(const SweepPart& part) {
  return fmt::format("{}/{}", part.number, part.count);
}

SweepPart parse_part(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = records::scan_integer(text.substr(0, slash));
  const auto count = records::scan_integer(text.substr(std::min(slash + 1, text.size())));
  if (!number || !count || !(1 <= *number && *number <= *count && *count <= most_sweep_parts)) {
    throw InputError("part", fmt::format("\"{}\"", records::printable(text, records::longest_word)),
                     fmt::format("must be I/N with 1 <= I <= N <= {}", most_sweep_parts));
  }
  return {*number, *count};
}

EntryRange range_of(const SweepPart& part, std::int64_t entries) {
  const std::int64_t least = entries / part.count;
  const std::int64_t longer = entries % part.count;  // this many have one entry more
  const std::int64_t before = part.number - 1;
  return {before * least + std::min(before, longer), least + (before < longer ? 1 : 0)};
}

std::string with_part(std::string path, const SweepPart& part) {
  constexpr std::string_view placeholder = "{part}";
  const std::string count = fmt::format("{}", part.count);
  const std::string name = fmt::format("{:0{}}-of-{}", part.number, count.size(), count);
  for (std::size_t place = 0; (place = path.find(placeholder, place)) != std::string::npos;
       place += name.size()) {
    path.replace(place, placeholder.size(), name);
  }
  return path;
}

}  // namespace stillpoint::sweep
