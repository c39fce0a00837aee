// SPDX-License-Identifier: MIT
#include "record_reader.hpp"

#include <stillpoint/core/names.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::records {

namespace {

constexpr char end_of_dos_file = '\x1A';

/// Bytes that text does not contain. A form feed and DOS's end of file may be in a trailer, and
/// programs in Fortran leave a NUL in a title.
bool is_binary(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20U && c != '\0' && c != '\t' && c != '\n' && c != '\r' && c != '\f' &&
         c != end_of_dos_file;
}

}  // namespace

RecordReader::RecordReader(std::string_view text, const std::string& path,
                           const RecordOptions& options)
    : path_(&path), options_(&options), rest_(text) {
  if (rest_.starts_with(byte_order_mark)) {
    rest_.remove_prefix(byte_order_mark.size());
  }
  if (rest_.ends_with(end_of_dos_file)) {
    rest_.remove_suffix(1);
  }
  if (rest_.empty()) {
    throw FileError({"record", path}, "is empty");
  }
  const auto* const found = std::ranges::find_if(rest_, is_binary);
  if (found != rest_.end()) {
    const auto line = 1 + std::count(rest_.begin(), found, '\n');
    refuse(static_cast<std::size_t>(line), fmt::format("is not text: it contains the byte 0x{:02X}",
                                                       static_cast<unsigned>(*found)));
  }
}

bool RecordReader::next() {
  if (rest_.empty()) {
    return false;
  }
  line_ = rest_.substr(0, rest_.find_first_of("\r\n"));
  rest_.remove_prefix(line_.size());
  const std::size_t returns = std::min(rest_.find_first_not_of('\r'), rest_.size());
  const bool feeds = rest_.substr(returns).starts_with('\n');
  rest_.remove_prefix(std::min(feeds ? returns + 1 : 1, rest_.size()));
  ++number_;
  return true;
}

void RecordReader::refuse_word(std::string_view word, std::string_view message) const {
  const auto column = static_cast<std::size_t>(word.data() - line_.data()) + 1;
  throw FileError({"record", *path_, number_, column}, fmt::format("{} {}", quoted(word), message));
}

void RecordReader::refuse_number(std::string_view word, NumberFault fault) const {
  refuse_word(word, fmt::format("{}{}", explanation(fault), comma_note(word)));
}

void RecordReader::refuse(std::size_t number, std::string_view message) const {
  throw FileError({"record", *path_, number}, message);
}

void RecordReader::refuse_step(std::size_t line, std::string_view what) const {
  if (options_->step && !options_->step_for_others) {
    refuse(line, fmt::format("{}, so record-step = {} must not be given", what, *options_->step));
  }
}

double RecordReader::file_step(std::size_t line, std::string_view name, double step) const {
  refuse_step(line, fmt::format("the file gives {}", name));
  if (!(step > 0)) {
    refuse(line, fmt::format("{} = {}: must be more than 0", name, step));
  }
  if (!options_->clock.holds_step(step)) {
    refuse(line, fmt::format("{} = {}: {}", name, step, step_bounds(options_->clock)));
  }
  return step / options_->clock.per_tau;
}

double RecordReader::parse_number(std::string_view word) const {
  const ScannedNumber scanned = scan_fortran_number(word);
  if (scanned.fault != NumberFault::none) {
    refuse_number(word, scanned.fault);
  }
  return scanned.value;
}

void RecordReader::set_units(RecordUnits units) {
  constexpr double cm = 100;
  constexpr double mm = 1000;
  const double metres = units == RecordUnits::cm_per_s2   ? cm
                        : units == RecordUnits::mm_per_s2 ? mm
                                                          : 1;
  units_per_g_ = units == RecordUnits::g ? 1 : metres * options_->gravity_m_per_s2;
}

void RecordReader::set_units(RecordUnits units, std::size_t line) {
  if (options_->units && *options_->units != units) {
    refuse(line, fmt::format("the values are in {}, but record-units = {}", name(units),
                             name(*options_->units)));
  }
  set_units(units);
}

std::optional<double> RecordReader::in_g(double given) const {
  const double value = given * options_->scale / units_per_g_;
  const bool fits = std::isnormal(value) && std::abs(value) <= options_->clock.largest_load();
  return given == 0 || fits ? std::optional(value) : std::nullopt;
}

std::string RecordReader::load_bounds() const {
  return fmt::format(
      "is out of range: in g it must be 0 or have a magnitude from 2.2e-308 to {:.3g}",
      options_->clock.largest_load());
}

double RecordReader::parse_acceleration(std::string_view word) const {
  ScannedNumber given = scan_fortran_number(word);
  if (given.fault == NumberFault::out_of_range) {
    given.value = HUGE_VAL;
  } else if (given.fault != NumberFault::none) {
    refuse_number(word, given.fault);
  }
  const auto value = in_g(given.value);
  if (!value) {
    refuse_word(word, load_bounds());
  }
  return *value;
}

std::span<const Named<RecordUnits>> enumerators(RecordUnits) noexcept {
  static constexpr auto rows =
      std::to_array<Named<RecordUnits>>({{RecordUnits::g, "g"},
                                         {RecordUnits::m_per_s2, "m/s2"},
                                         {RecordUnits::cm_per_s2, "cm/s2"},
                                         {RecordUnits::mm_per_s2, "mm/s2"}});
  return rows;
}

std::string step_bounds(const RecordClock& clock) {
  return fmt::format("must be from {:.3g} to {:.3g} {}", clock.shortest(), clock.latest(),
                     clock.unit);
}

}  // namespace stillpoint::records
