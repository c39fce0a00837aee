// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/npy.hpp>

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstddef>

namespace stillpoint::sweep {

namespace {

constexpr char byte_order = std::endian::native == std::endian::little ? '<' : '>';

constexpr std::string_view magic = "\x93NUMPY\x01";  // and a null character
constexpr std::size_t before_text = 10;  // magic, and the length of the text in two bytes
constexpr std::string_view before_rows = "'shape': (";

}  // namespace

std::string npy_number(std::string_view name) {
  return fmt::format("('{}', '{}f8'), ", name, byte_order);
}

std::string npy_header(const std::string& fields, std::int64_t rows) {
  constexpr std::size_t alignment = 64;  // of the rows, as NumPy has it
  // The header must not grow when the number of rows is filled in.
  constexpr std::int64_t most_rows = 1'000'000'000'000'000'000;
  const std::string_view all_fields =
      std::string_view(fields).substr(0, fields.size() - 2);  // ", "
  std::string text = fmt::format("{{'descr': [{}], 'fortran_order': False, {}{},), }}", all_fields,
                                 before_rows, most_rows);
  const std::size_t longest = before_text + text.size() + 1;
  text.resize((longest + alignment - 1) / alignment * alignment - before_text - 1, ' ');
  text += '\n';
  assert(text.size() < 0x10000U);
  std::string header(magic);
  header += '\0';
  header += static_cast<char>(text.size() & 0xFFU);
  header += static_cast<char>(text.size() >> 8U);
  return with_rows(header + text, rows);
}

std::string with_rows(std::string header, std::int64_t rows) {
  const std::size_t size = header.size();
  const std::size_t shape = header.find(before_rows);
  if (!header.starts_with(magic) || shape == std::string::npos) {
    return header;
  }
  const std::size_t begin = shape + before_rows.size();
  header.replace(begin, header.find(',', begin) - begin, fmt::format("{}", rows));
  header.resize(header.find_last_not_of(" \n") + 1);
  header.resize(size - 1, ' ');
  return header + '\n';
}

}  // namespace stillpoint::sweep
