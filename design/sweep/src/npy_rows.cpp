// SPDX-License-Identifier: MIT
#include "rows.hpp"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstring>

namespace stillpoint::sweep {

namespace {

constexpr char byte_order = std::endian::native == std::endian::little ? '<' : '>';

bool is_byte(Quantity column) {
  return form(column) != Form::number;
}

std::size_t width(Quantity column) {
  return is_byte(column) ? 1 : sizeof(double);
}

std::string description(const std::vector<Quantity>& columns, std::int64_t rows) {
  std::string fields;
  for (const Quantity column : columns) {
    fields += form(column) == Form::truth ? fmt::format("('{}', '|b1'), ", name(column))
              : is_byte(column)           ? fmt::format("('{}', '|u1'), ", name(column))
                                : fmt::format("('{}', '{}f8'), ", name(column), byte_order);
  }
  fields.resize(fields.size() - 2);
  return fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", fields, rows);
}

}  // namespace

std::string npy_header(const std::vector<Quantity>& columns, std::int64_t rows) {
  constexpr std::size_t alignment = 64;
  constexpr std::int64_t most_rows = 1'000'000'000'000'000'000;
  using namespace std::string_literals;
  const std::string start = "\x93NUMPY\x01\x00"s;
  const std::size_t longest = start.size() + 2 + description(columns, most_rows).size() + 1;
  const std::size_t size = (longest + alignment - 1) / alignment * alignment;
  std::string header = start + "  " + description(columns, rows);
  header.resize(size - 1, ' ');
  header += '\n';
  const std::size_t counted = size - start.size() - 2;
  assert(counted < 0x10000U);
  header[start.size()] = static_cast<char>(counted & 0xFFU);
  header[start.size() + 1] = static_cast<char>(counted >> 8U);
  return header;
}

void append_npy(const SweepBlock& block, const std::vector<Quantity>& columns, Eigen::Index begin,
                Eigen::Index end, std::string& bytes) {
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
    for (Eigen::Index i = begin; i < end; ++i, place += row) {
      if (is_byte(column)) {
        *place = static_cast<char>(values[i]);
      } else {
        std::memcpy(place, values + i, sizeof(double));
      }
    }
    field += width(column);
  }
}

}  // namespace stillpoint::sweep
