// SPDX-License-Identifier: MIT

// Numerical stability: computes each hard case by the program, by the naive formula and in 50
// digits. Prints the page docs/accuracy.md, or writes it.

#include "../machine.hpp"
#include "hard_case.hpp"

#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::accuracy {

namespace {

struct Row {
  HardCase hard_case;
  Finding finding;
};

struct Section {
  std::string heading;
  std::vector<Row> rows;
};

std::string ulps(double error) {
  return error < 100 ? fmt::format("{:.1f}", error) : fmt::format("{:.0e}", error);
}

std::string ulps(const std::optional<double>& error) {
  return error ? ulps(*error) : "";
}

void add(std::string& text, const Section& section) {
  auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n## {}\n\n"
                 "| case | quantity | expected | condition number | error | worst | worst by "
                 "condition | naive error | naive worst |\n|---|---|---|---|---|---|---|---|---|\n",
                 section.heading);
  for (const auto& [now, found] : section.rows) {
    fmt::format_to(end, "| {} | `{}` | {:.17g} | {:.1e} | {} | {} of {} | {} | {} | {} |\n",
                   now.name, now.metric, found.expected, found.condition, ulps(found.error),
                   ulps(found.worst), now.neighbours, ulps(found.worst_by_condition),
                   ulps(found.naive_error), ulps(found.naive_worst));
  }
  text += "\nWhy each case is hard, and its naive formula:\n\n";
  std::string_view said;
  for (const auto& [now, found] : section.rows) {
    if (now.why == said) {
      continue;  // the same trouble at another size
    }
    said = now.why;
    fmt::format_to(end, "- {}: {}.{}\n", now.name, now.why,
                   now.naive.empty() ? "" : fmt::format(" Naive: {}.", now.naive));
  }
}

/// docs/accuracy.md
std::string page(const std::vector<Section>& sections) {
  const bench::Machine machine = bench::this_machine();
  std::string text = fmt::format(
      "# Accuracy of the hard cases\n\n"
      "This page shows how many digits are right where a formula is most likely to lose them. "
      "`./dev accuracy --update-docs` writes it. {}, `{}`.\n\n"
      "Each quantity is computed by the program in double precision, by the obvious (naive) "
      "formula where there is one, and in 50 digits from the same doubles. Errors are in units in "
      "the last place (ulp) of the expected value. *Worst* is the largest error of the given "
      "number of random neighbours that are as hard. The *condition number* is the sum over the "
      "inputs of |input/value d value/d input|: if each input is off by 2^-53 of itself, the value "
      "changes by that many 2^-53, however it is computed. So *worst by condition*, the error "
      "divided by the condition number where that is above 1, is what the computation itself "
      "lost. For a free motion of n half-cycles it is promised to be at most 2 (2 + n).\n",
      machine.compiler, machine.flags);
  for (const Section& section : sections) {
    add(text, section);
  }
  return text;
}

Section section(const std::string& heading, const std::vector<HardCase>& cases) {
  Section result{heading, {}};
  for (const HardCase& now : cases) {
    fmt::print(stderr, "accuracy: {}\n", now.name);
    result.rows.push_back({now, examine(now)});
  }
  return result;
}

int run(int count, char** arguments) {
  const std::string text =
      page({section("Free motion", free_cases()), section("Admissible region", region_cases()),
            section("Forced motion", forced_cases())});
  if (count < 2) {
    fmt::print("{}", text);
    return 0;
  }
  std::ofstream file(arguments[1], std::ios::binary);
  file << text << std::flush;
  if (!file) {
    throw std::runtime_error(std::string(arguments[1]) + " could not be written");
  }
  return 0;
}

}  // namespace

}  // namespace stillpoint::accuracy

int main(int count, char** arguments) {
  try {
    return stillpoint::accuracy::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "accuracy: {}\n", error.what());
    return 1;
  }
}
