// SPDX-License-Identifier: MIT
#include "sweep_table.hpp"
#include "testing/printing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <sstream>

namespace stillpoint::cli_test {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts(1);
  for (const char sign : line) {
    sign == ',' ? static_cast<void>(parts.emplace_back()) : parts.back().push_back(sign);
  }
  return parts;
}

std::size_t size_of(const NpyField& field) {
  return field.type == "<f8" ? 8 : 1;
}

}  // namespace

const std::string& SweepTable::at(std::size_t row, std::string_view column) const {
  const auto found = std::ranges::find(columns, column);
  if (found == columns.end()) {
    throw std::out_of_range("no column " + std::string(column));
  }
  return rows.at(row).at(static_cast<std::size_t>(found - columns.begin()));
}

double SweepTable::number(std::size_t row, std::string_view column) const {
  const std::string& text = at(row, column);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  BOOST_TEST((read.ec == std::errc() && read.ptr == text.data() + text.size()),
             column << " = " << text);
  return value;
}

SweepTable read_csv(std::string_view text) {
  SweepTable table;
  BOOST_TEST(text.ends_with('\n'));
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    if (table.columns.empty()) {
      table.columns = split(line);
    } else {
      table.rows.push_back(split(line));
      BOOST_TEST(table.rows.back().size() == table.columns.size(), line);
    }
  }
  return table;
}

Arguments inputs_of(const SweepTable& table, std::size_t row) {
  static const std::array results{"peak_amplitude", "peak_m", "peak_absolute_acceleration",
                                  "feasible", "trade_off"};
  Arguments options;
  for (const std::string& column : table.columns) {
    if (std::ranges::find(results, column) != results.end()) {
      break;
    }
    const std::string& value = table.at(row, column);
    if (column.ends_with("_low")) {  // behind the other end
      options.back() = value + ":" + options.back();
    } else if (column.ends_with("_high")) {
      options.back() += ":" + value;
    } else {
      options.push_back("--" + column);
      std::ranges::replace(options.back(), '_', '-');
      options.push_back(value);
    }
  }
  return options;
}

std::size_t NpyFile::record_size() const {
  std::size_t size = 0;
  for (const NpyField& field : fields) {
    size += size_of(field);
  }
  return size;
}

const char* NpyFile::place(std::int64_t row, std::string_view field) const {
  std::size_t offset = static_cast<std::size_t>(row) * record_size();
  for (const NpyField& one : fields) {
    if (one.name == field) {
      return bytes.data() + offset;
    }
    offset += size_of(one);
  }
  throw std::out_of_range("no field " + std::string(field));
}

double NpyFile::number(std::int64_t row, std::string_view field) const {
  double value = 0;
  std::memcpy(&value, place(row, field), sizeof(value));
  return value;
}

int NpyFile::byte(std::int64_t row, std::string_view field) const {
  return static_cast<unsigned char>(*place(row, field));
}

NpyFile read_npy(const std::string& file) {
  // https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html, version 1.0
  constexpr std::size_t prefix = 10;
  BOOST_TEST_REQUIRE(file.size() > prefix);
  BOOST_TEST(file.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const auto low = static_cast<unsigned char>(file[8]);
  const auto high = static_cast<unsigned char>(file[9]);
  NpyFile npy;
  npy.header_size = prefix + low + std::size_t{256} * high;
  BOOST_TEST(npy.header_size % 64 == 0U);
  BOOST_TEST_REQUIRE(file.size() >= npy.header_size);
  const std::string header = file.substr(prefix, npy.header_size - prefix);
  BOOST_TEST(header.ends_with('\n'));
  const std::regex whole(
      R"(\{'descr': \[(.*)\], 'fortran_order': False, 'shape': \((\d+),\), \} *\n)");
  std::smatch parts;
  BOOST_TEST_REQUIRE(std::regex_match(header, parts, whole), header);
  npy.count = std::stoll(parts[2]);
  const std::string descriptions = parts[1];
  const std::regex field(R"(\('(\w+)', '([<|]\w+)'\))");
  for (std::sregex_iterator i(descriptions.begin(), descriptions.end(), field), end; i != end;
       ++i) {
    npy.fields.push_back({(*i)[1], (*i)[2]});
  }
  npy.bytes = file.substr(npy.header_size);
  BOOST_TEST(npy.bytes.size() == static_cast<std::size_t>(npy.count) * npy.record_size());
  return npy;
}

}  // namespace stillpoint::cli_test
