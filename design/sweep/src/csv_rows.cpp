// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/outcome.hpp>
#include "rows.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace stillpoint::sweep {

namespace {

void append_number(double value, std::string& text) {
  if (!std::isfinite(value)) {
    return;
  }
  constexpr std::size_t longest = 32;  // -2.2250738585072014e-308 has 24
  std::array<char, longest> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), written.ptr);
}

}  // namespace

std::string csv_header(const std::vector<Quantity>& columns) {
  std::string text;
  for (const Quantity column : columns) {
    text += name(column);
    text += ',';
  }
  text.back() = '\n';
  return text;
}

void append_csv(const SweepBlock& block, const std::vector<Quantity>& columns, Eigen::Index begin,
                Eigen::Index end, std::string& text) {
  for (Eigen::Index i = begin; i < end; ++i) {
    for (const Quantity column : columns) {
      const double value = block[column][i];
      switch (form(column)) {
        case Form::number:
          append_number(value, text);
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

}  // namespace stillpoint::sweep
