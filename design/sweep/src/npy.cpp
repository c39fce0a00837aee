// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/npy.hpp>

#include <fmt/format.h>

#include <bit>
#include <cassert>

namespace stillpoint::sweep {

namespace {

constexpr char byte_order = std::endian::native == std::endian::little ? '<' : '>';

std::string npy_description(std::string_view fields, std::int64_t rows) {
  fields.remove_suffix(2);  // ", "
  return fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", fields, rows);
}

}  // namespace

std::string npy_number(std::string_view name) {
  return fmt::format("('{}', '{}f8'), ", name, byte_order);
}

std::string npy_header(const std::string& fields, std::int64_t rows) {
  constexpr std::size_t alignment = 64;  // of the rows, as NumPy has it
  // The header must not grow when the number of rows is filled in.
  constexpr std::int64_t most_rows = 1'000'000'000'000'000'000;
  using namespace std::string_literals;
  const std::string start = "\x93NUMPY\x01\x00"s;
  const std::size_t longest = start.size() + 2 + npy_description(fields, most_rows).size() + 1;
  const std::size_t size = (longest + alignment - 1) / alignment * alignment;
  std::string header = start + "  " + npy_description(fields, rows);
  header.resize(size - 1, ' ');
  header += '\n';
  const std::size_t counted = size - start.size() - 2;
  assert(counted < 0x10000U);
  header[start.size()] = static_cast<char>(counted & 0xFFU);
  header[start.size() + 1] = static_cast<char>(counted >> 8U);
  return header;
}

}  // namespace stillpoint::sweep
