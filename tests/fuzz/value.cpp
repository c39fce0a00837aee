// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/units.hpp>
#include <stillpoint/sweep/axis.hpp>
#include <stillpoint/sweep/part.hpp>
#include <stillpoint/sweep/reduction.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <algorithm>
#include <functional>

// The values of options: numbers, units, ranges, axes, lists of columns, bins and parts. The first
// letter says which, the rest is the value.

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;
using namespace stillpoint::sweep;
using records::Dimension;

constexpr std::string_view field = "field";

const SweepSpec& spec() {
  static const SweepSpec spec{};
  return spec;
}

/// What is printed reads back as the same value.
void read_number(std::string_view text) {
  const double value = records::parse_number(field, text);
  require(std::isfinite(value), "a number that is not finite: {}", value);
  require(same_bits(records::parse_number(field, fmt::format("{}", value)), value),
          "{} is read as another number", value);
}

void read_unit(std::string_view text) {
  const auto dimension =
      static_cast<Dimension>(static_cast<unsigned char>(text.empty() ? '0' : text.front()) %
                             (static_cast<unsigned>(Dimension::gravities) + 1));
  text.remove_prefix(text.empty() ? 0 : 1);
  const double value = records::parse_value(field, dimension, text);
  require(std::isfinite(value), "a value that is not finite: {}", value);
  if (!records::has_unit(text)) {
    require(same_bits(records::parse_number(field, text), value), "{} without a unit", value);
  }
}

void read_axis(std::string_view text, RangeEnd standing) {
  const auto number = [](std::string_view word) { return records::parse_number(field, word); };
  const Axis axis = parse_axis(field, text, number, standing);
  const Axis again = parse_axis(field, axis.text(), number, standing);
  require(axis.size() == again.size() && axis.size() >= 1, "axis {}", axis.text());
  for (const std::int64_t i : {std::int64_t{0}, axis.size() / 2, axis.size() - 1}) {
    require(std::isfinite(axis[i]) && same_bits(axis[i], again[i]), "axis {}, value {} = {}",
            axis.text(), i, axis[i]);
    const auto [least, most] = axis.ends();
    require(axis[i] >= least && axis[i] <= most, "axis {}, value {} = {}", axis.text(), i, axis[i]);
  }
}

void read_bins(std::string_view text) {
  const BinsRequest bins = parse_bins(text, default_columns(spec(), true), {});
  require(bins.edges.size() >= 2 && std::ranges::is_sorted(bins.edges, std::less_equal()),
          "the edges of bins do not rise");
}

void read(char kind, std::string_view text) {
  switch (kind) {
    case 'n':
      return read_number(text);
    case 'i':
      return static_cast<void>(records::parse_integer(field, text));
    case 'u':
      return read_unit(text);
    case 'a':
      return read_axis(text, RangeEnd::none);
    case 'r':
      return read_axis(text, RangeEnd::high);
    case 'z':
      return static_cast<void>(records::parse_zones(field, Dimension::length, text));
    case 'c':
      return static_cast<void>(parse_columns(text, SweepKind::forced));
    case 'h':
      return read_bins(text);
    default: {
      const SweepPart part = parse_part(text);
      require(parse_part(sweep::text(part)) == part, "part {}", sweep::text(part));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0) {
    const std::string_view text = text_of(data, size);
    accepted([text] { read(text.front(), text.substr(1)); });
  }
  return 0;
}
