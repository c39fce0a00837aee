// SPDX-License-Identifier: MIT
#include "rows.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/sweep/npy.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;

void append_number(double value, std::string& text) {
  if (!std::isfinite(value)) {
    return;
  }
  constexpr std::size_t longest = 32;  // -2.2250738585072014e-308 has 24
  std::array<char, longest> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), written.ptr);
}

bool is_byte(Quantity column) {
  return form(column) != Form::number;
}

std::size_t width(Quantity column) {
  return is_byte(column) ? 1 : sizeof(double);
}

using Units = std::optional<SweepUnits>;

/// As NumPy describes records with the columns as fields: 8-byte floats, but bytes for outcome and
/// feasible.
std::string fields_of(const std::vector<Quantity>& columns, const Units& units) {
  std::string fields;
  for (const Quantity column : columns) {
    fields += form(column) == Form::truth ? fmt::format("('{}', '|b1'), ", name(column, units))
              : is_byte(column)           ? fmt::format("('{}', '|u1'), ", name(column, units))
                                          : npy_number(name(column, units));
  }
  return fields;
}

/// A text as a cell of CSV, RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string cell = "\"";
  for (const char character : text) {
    cell.append(character == '"' ? 2 : 1, character);
  }
  return cell + '"';
}

/// The names of the columns, in one line.
std::string csv_header(const std::vector<Quantity>& columns, const Units& units) {
  std::string text;
  for (const Quantity column : columns) {
    text += name(column, units);
    text += ',';
  }
  text.back() = '\n';
  return text;
}

/// The entries begin <= i < end, a line each: numbers as the shortest decimals that read back to
/// the same double, nothing for a value that does not exist or never comes.
void append_csv(const SweepBlock& block, const std::vector<Quantity>& columns,
                const std::vector<std::string>& records, Index begin, Index end,
                std::string& text) {
  for (Index i = begin; i < end; ++i) {
    for (const Quantity column : columns) {
      const double value = block[column][i];
      switch (form(column)) {
        case Form::number:
          if (column == Quantity::record) {
            text += records[static_cast<std::size_t>(value)];
          } else {
            append_number(value, text);
          }
          break;
        case Form::outcome:
          text += sweep_outcome_name(static_cast<std::size_t>(value));
          break;
        case Form::truth:
          text += value != 0 ? "true" : "false";
          break;
      }
      text += ',';
    }
    text.back() = '\n';
  }
}

/// The entries begin <= i < end, a packed record each.
void append_npy(const SweepBlock& block, const std::vector<Quantity>& columns, Index begin,
                Index end, std::string& bytes) {
  std::size_t row = 0;
  for (const Quantity column : columns) {
    row += width(column);
  }
  const std::size_t before = bytes.size();
  bytes.resize(before + static_cast<std::size_t>(end - begin) * row);
  char* field = bytes.data() + before;
  for (const Quantity column : columns) {
    const double* const values = block[column].data();
    char* place = field;
    for (Index i = begin; i < end; ++i, place += row) {
      if (is_byte(column)) {
        *place = static_cast<char>(values[i]);
      } else {
        std::memcpy(place, values + i, sizeof(double));
      }
    }
    field += width(column);
  }
}

}  // namespace

RowWriter::RowWriter(const SweepSpec& spec)
    : columns_(spec.columns), units_(spec.units), format_(spec.format), threads_(spec.threads) {
  for (const NamedRecord& record : spec.records) {
    records_.push_back(quoted(record.name));
  }
}

std::string RowWriter::header(std::int64_t rows) const {
  return format_ == RowFormat::csv ? csv_header(columns_, units_)
                                   : npy_header(fields_of(columns_, units_), rows);
}

const std::vector<std::string>& RowWriter::rows(const SweepBlock& block) {
  constexpr Index piece = 4096;  // entries: about 300 kB, enough to be worth a thread
  pieces_.resize(static_cast<std::size_t>((block.size + piece - 1) / piece));
  for_each_entry(static_cast<Index>(pieces_.size()), threads_, {}, [&](Index i) {
    std::string& bytes = pieces_[static_cast<std::size_t>(i)];
    bytes.clear();
    const Index begin = i * piece;
    const Index end = std::min(begin + piece, block.size);
    if (format_ == RowFormat::csv) {
      append_csv(block, columns_, records_, begin, end, bytes);
    } else {
      append_npy(block, columns_, begin, end, bytes);
    }
  });
  return pieces_;
}

}  // namespace stillpoint::sweep
