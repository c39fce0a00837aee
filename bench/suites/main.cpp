// SPDX-License-Identifier: MIT
// The tables of docs/records-design.md: whether the search finds the best damper, and what a notch
// brings.

#include "dense_scan.hpp"
#include "suites.hpp"

#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::bench {

namespace {

using design::RecordDesign;
using design::RecordDesignRequest;
using design::SuitePoint;

/// The accuracy that the docs promise.
constexpr double largest_excess = 1e-4;

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

std::string damper_text(const design::SuiteDamper& damper) {
  return fmt::format("{:.5f} | {:.2f} mm | {:.3f} s", damper.f, 1e3 * damper.delta / metre,
                     2.8 / damper.p);
}

/// Whether no suite's dense scan beats its design.
bool compare_with_dense_scans(const std::vector<NamedSuite>& all) {
  fmt::print(
      "| suite | notch | f | delta | period | objective | found by | excess over the scan's "
      "best | points | processor time of the design "
      "|\n|---|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const auto& [name, request] : all) {
    const double begin = processor_seconds();
    const RecordDesign result = design::design(request);
    const double seconds = processor_seconds() - begin;
    const SuitePoint& point = result.nearest;
    const double found = result.finding ? value_of(point.figures, request.objective) : HUGE_VAL;
    const DenseBest dense = dense_best(result.request, point.damper, found);
    const double excess = found / dense.value - 1;
    good = good && (excess <= largest_excess || std::isinf(dense.value));
    const bool is_length = request.objective != design::SuiteObjective::acceleration;
    fmt::print(
        "| {} | {} | {} | {} | {} | {:.1e} | {} | {:.1f} s |\n", name, notch_words(request),
        damper_text(point.damper),
        is_length ? fmt::format("{:.2f} mm", 1e3 * found / metre) : fmt::format("{:.5f} g", found),
        result.search.algorithm, excess, dense.points, seconds);
    if (excess > largest_excess) {
      fmt::print(stderr, "{}: the scan has {:.17g} at {}, {:.17g} {:.17g}\n", name, dense.value,
                 damper_text(dense.damper), dense.damper.f, dense.damper.delta);
    }
    std::fflush(stdout);
  }
  return good;
}

/// The best of a notch's values is refined between its neighbours this often.
constexpr int refinements = 3;

double objective_of(const std::optional<RecordDesign>& design) {
  return design ? value_of(design->finding->point.figures, design->request.objective) : HUGE_VAL;
}

/// The best design with a notch made by `notch` from any of `values`, which rise, or from one
/// between two of them; empty if none was found.
std::optional<RecordDesign> best_of(const std::vector<double>& values,
                                    const std::function<RecordDesignRequest(double)>& notch) {
  std::map<double, std::optional<RecordDesign>> tried;
  const auto attempt = [&](double value) {
    RecordDesign now = design::design(notch(value));
    tried[value] = now.finding ? std::optional(std::move(now)) : std::nullopt;
  };
  const auto best = [&] {
    return std::ranges::min_element(tried, {},
                                    [](const auto& each) { return objective_of(each.second); });
  };
  std::ranges::for_each(values, attempt);
  for (int i = 0; i < refinements && best()->second; ++i) {
    const auto here = best();
    std::vector<double> between;
    if (here != tried.begin()) {
      between.push_back((here->first + std::prev(here)->first) / 2);
    }
    if (std::next(here) != tried.end()) {
      between.push_back((here->first + std::next(here)->first) / 2);
    }
    std::ranges::for_each(between, attempt);
  }
  return best()->second;
}

void print_gains(const std::vector<NamedSuite>& all) {
  fmt::print(
      "| suite | notch | f | delta | period | transmitted | stroke | residual | of the residual "
      "removed |\n|---|---|---|---|---|---|---|---|---|\n");
  std::string last;
  for (const auto& [name, suite] : all) {
    if (std::exchange(last, name) == name || suite.p.low < suite.p.high) {
      continue;  // another notch of the same suite, or a period that varies
    }
    RecordDesignRequest paper = suite;
    paper.hold = std::nullopt;
    paper.notch_width.reset();
    RecordDesignRequest none = paper;
    none.delta = Interval{0, 0};
    const auto with_hold = [&](double hold) {
      RecordDesignRequest request = paper;
      request.hold = hold;
      return request;
    };
    const auto with_width = [&](double mm) {
      RecordDesignRequest request = paper;
      request.notch_width = mm * 1e-3 * metre;
      return request;
    };
    std::optional<double> without;
    for (const auto& [words, best] :
         {std::pair("none", best_of({0}, [&](double) { return none; })),
          std::pair("the paper's", best_of({0}, [&](double) { return paper; })),
          std::pair("any hold", best_of({0, 0.0125, 0.025, 0.05, 0.1, 0.2, 0.4}, with_hold)),
          std::pair("any width", best_of({5, 10, 20, 50, 100, 200, 400}, with_width))}) {
      const bool is_none = words == std::string_view("none");
      if (!best) {
        fmt::print("| {} | {} | no damper found | | | | | | |\n", name, words);
        continue;
      }
      const auto& [damper, figures] = best->finding->point;
      if (is_none) {
        without = figures.residual;
      }
      fmt::print(
          "| {} | {} | {} | {:.4f} g | {:.1f} mm | {:.2f} mm | {} |\n", name,
          is_none ? "none" : notch_words(best->request), damper_text(damper), figures.acceleration,
          1e3 * figures.peak / metre, 1e3 * figures.residual / metre,
          is_none || !without || *without == 0
              ? std::string()
              : fmt::format("{:.0f} %", std::round(100 * (1 - figures.residual / *without)) + 0.0));
      std::fflush(stdout);
    }
  }
}

int run(int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2 || (words[0] != "truth" && words[0] != "notches")) {
    fmt::print(stderr, "usage: stillpoint_suites truth|notches RECORDS_FOLDER [RECORD...]\n");
    return 2;
  }
  const std::vector<NamedSuite> all = suites(words[1], {words.begin() + 2, words.end()});
  if (words[0] == "truth") {
    return compare_with_dense_scans(all) ? 0 : 1;
  }
  print_gains(all);
  return 0;
}

}  // namespace

}  // namespace stillpoint::bench

int main(int argc, char** argv) {
  try {
    return stillpoint::bench::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
