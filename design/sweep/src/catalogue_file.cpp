// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/catalogue_file.hpp>

#include "csv_file.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace stillpoint::sweep {

namespace {

using records::longest_word;
using records::printable;

/// Reads the file line by line; every error names the line.
class CatalogueReader {
 public:
  CatalogueReader(const std::string& path, const CatalogueUnits& units)
      : file_(path, "catalogue", " with name, f, and delta or delta_m"), units_(units) {}

  std::vector<design::Part> parts() {
    read_header();
    std::vector<design::Part> parts;
    while (file_.next()) {
      if (parts.size() == most_parts) {
        refuse(fmt::format("there are more than {} parts", most_parts));
      }
      parts.push_back(part());
    }
    if (parts.empty()) {
      file_.refuse({}, "has no parts: below the header there must be at least one");
    }
    return parts;
  }

 private:
  void read_header() {
    name_ = column("name");
    f_ = column("f");
    delta_ = column("delta");
    delta_m_ = column("delta_m");
    if (!name_ || !f_ || (!delta_ && !delta_m_)) {
      refuse(
          fmt::format("the header has no column {}: it must have name, f, and delta or delta_m, "
                      "separated by commas",
                      !name_ ? "name"
                      : !f_  ? "f"
                             : "delta or delta_m"));
    }
    if (delta_ && delta_m_) {
      refuse("the header has both delta and delta_m: give one of them");
    }
    if (delta_ && units_.metres_only) {
      refuse("the column delta is dimensionless: with physical input give delta_m");
    }
    if (delta_m_ && !units_.length_m) {
      refuse(
          "the column delta_m is in metres, so the task must be too: give --velocity and "
          "--max-displacement, or a column delta");
    }
  }

  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const {
    const auto& names = file_.names();
    if (std::ranges::count(names, name) > 1) {
      refuse(fmt::format("the column {} appears twice", name));
    }
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - names.begin()));
  }

  design::Part part() {
    const std::string name = file_.text(*name_);
    if (name.empty()) {
      refuse("name is empty: every part must have one");
    }
    if (name.size() > longest_part_name || printable(name, longest_part_name) != name) {
      refuse(fmt::format("name = {}: must be printable UTF-8 of at most {} bytes",
                         printable(name, longest_word), longest_part_name));
    }
    if (const auto [first, alone] = line_of_.emplace(name, file_.line()); !alone) {
      refuse(fmt::format("name = {}: appears twice, first on line {}", name, first->second));
    }
    design::Part part{name, number("f", *f_, 1), 0};
    part.delta =
        delta_ ? number("delta", *delta_, 1) : number("delta_m", *delta_m_, *units_.length_m);
    try {
      if (units_.p) {
        require_valid(Oscillator{*units_.p, part.f, part.delta});
      }
    } catch (const InputError& error) {
      refuse(error.what());
    }
    return part;
  }

  /// The value of a cell in dimensionless units, of which one is `unit` in the cell's units.
  [[nodiscard]] double number(std::string_view field, std::size_t column, double unit) const {
    const std::string_view text = records::trimmed(file_.text(column));
    double value = 0;
    try {
      value = field == "delta_m" ? units_.parse_metres(text) : records::parse_number(field, text);
    } catch (const InputError& error) {
      refuse(printable(error.what(), 4 * longest_word));
    }
    if (!(value >= 0 && value / unit <= design::largest_part_value)) {
      refuse(fmt::format("{} = {}: must be a number from 0 to {:.3g}", field,
                         printable(text, longest_word),
                         design::largest_part_value * std::min(unit, 1.0)));
    }
    return value / unit;
  }

  [[noreturn]] void refuse(std::string_view what) const { file_.refuse(file_.line(), what); }

  CsvFile file_;
  const CatalogueUnits& units_;
  std::optional<std::size_t> name_, f_, delta_, delta_m_;
  std::unordered_map<std::string, std::int64_t> line_of_;
};

}  // namespace

std::vector<design::Part> read_catalogue(const std::string& path, const CatalogueUnits& units) {
  return CatalogueReader(path, units).parts();
}

}  // namespace stillpoint::sweep
