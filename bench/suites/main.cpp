// SPDX-License-Identifier: MIT
// Whether the search under records finds the best box: docs/records-design.md section 3.

#include "suites.hpp"

#include "testing/dense_boxes.hpp"

#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::bench {

namespace {

using design::RecordDesign;

/// The accuracy that the docs promise, and the gain without which a notch is left out.
constexpr double largest_excess = 5e-3;
constexpr double least_gain = 0.01;

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// The best box with a notch and without, as far as the task allows them.
std::optional<test::DenseBox> dense_best(const RecordDesign& design) {
  const test::DenseBoxes truth(design.request);
  const bool three = design.request.p.low < design.request.p.high;
  std::optional<test::DenseBox> best = truth.best(32, true);
  if (design.request.delta->high > 0) {
    const auto with_notch = truth.best(three ? 3 : 6, false);
    if (with_notch && (!best || with_notch->value < best->value * (1 - least_gain))) {
      best = with_notch;
    }
  }
  return best;
}

/// Whether no suite's dense scan beats its design.
bool compare(const std::vector<NamedSuite>& all) {
  fmt::print(
      "| suite | notch | tolerance | f | delta | period | objective | excess over the scan's best "
      "| processor time |\n|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const NamedSuite& each : all) {
    for (const double tolerance : {0.05, 0.1, 0.2}) {
      design::RecordDesignRequest request = each.request;
      request.tolerance = {
          {tolerance, tolerance}, {tolerance, tolerance}, {tolerance, tolerance}, {}};
      const double begin = processor_seconds();
      const RecordDesign design = design::design(request);
      const double seconds = processor_seconds() - begin;
      const auto best = dense_best(design);
      const double found =
          design.finding ? design.nearest.figures.*minimised(request).value : HUGE_VAL;
      const double excess = best ? found / best->value - 1 : 0;
      good = good && excess <= largest_excess;
      const design::SuiteDamper& damper = design.nearest.damper;
      fmt::print("| {} | {} | {} | {:.5f} | {:.2f} mm | {:.3f} s | {} | {} | {:.1f} s |\n",
                 each.name, notch_words(request), tolerance, damper.f, 1e3 * damper.delta / metre,
                 2.8 / damper.p, design.finding ? fmt::format("{:.5f}", found) : "none",
                 best ? fmt::format("{:.2g} %", 100 * excess) : "the scan has none", seconds);
      std::fflush(stdout);
      if (excess > largest_excess) {
        fmt::print(stderr, "the scan has {:.6g} at f = {:.6g}, delta = {:.6g}, period {:.4f} s\n",
                   best->value, best->design[0], best->design[1], 2.8 * best->design[2]);
      }
    }
  }
  return good;
}

int run(int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() != 2 || words[0] != "truth") {
    fmt::print(stderr, "usage: stillpoint_suites truth RECORDS_FOLDER\n");
    return 2;
  }
  const char* const more = std::getenv("STILLPOINT_RECORDS");
  return compare(
             suites(words[1], more != nullptr ? std::optional<std::string>(more) : std::nullopt))
             ? 0
             : 1;
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
