// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"

#include <stillpoint/design/region.hpp>

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

namespace {

using design::Criterion;
using design::Problem;
using design::Strip;

constexpr double not_binding = 2;  // times V0/p

std::string row(const std::string& head, const std::vector<std::string>& cells) {
  std::string line = fmt::format("| {} |", head);
  for (const std::string& cell : cells) {
    line += cell.empty() ? " |" : fmt::format(" {} |", cell);
  }
  return line + "\n";
}

std::string rule(std::size_t columns) {
  std::string line = "|";
  for (std::size_t i = 0; i < columns; ++i) {
    line += "---|";
  }
  return line + "\n";
}

/// In per cent, with four digits, of each strip of the first six arrivals.
std::string strips_row(const std::string& head, double beta, std::optional<double> f_max) {
  constexpr std::int64_t arrivals = 6;
  std::vector<std::string> cells(arrivals);
  const Problem problem{1, 1, beta, Criterion::exact, arrivals};
  for (const Strip& strip : strips(problem, {.f_max = f_max})) {
    cells[static_cast<std::size_t>(strip.arrival - 1)] =
        fmt::format("{:#.4g}", 100 * strip.tolerance);
  }
  return row(head, cells);
}

/// In per cent, of the boxes in which every rest is within the residual.
std::string residual_row(double residual) {
  std::vector<std::string> cells;
  for (const std::int64_t half_cycles : {1, 2, 3, 4, 6}) {
    Problem problem{1, 1, not_binding, Criterion::exact, half_cycles};
    problem.residual = residual;
    cells.push_back(fmt::format("{:.2f}", 100 * strips(problem).back().tolerance));
  }
  return row(fmt::format("{}", residual), cells);
}

}  // namespace

std::string tolerance_tables() {
  std::string text = row("beta", {"n = 1", "2", "3", "4", "5", "6"}) + rule(7);
  for (const double beta : {0.8, 0.9, 0.95, 0.99}) {
    text += strips_row(fmt::format("{}", beta), beta, {});
  }
  text += strips_row("does not bind", not_binding, {});
  text += strips_row("does not bind, f <= 0.001", not_binding, 0.001);
  text += "\n" + row("R p / V0", {"1", "2", "3", "4", "6"}) + rule(6);
  for (const double residual : {0.001, 0.05, 0.1}) {
    text += residual_row(residual);
  }
  return text;
}

}  // namespace stillpoint::cli
