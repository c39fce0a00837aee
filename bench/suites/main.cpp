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
using design::RecordDesignRequest;

/// The accuracy that the docs promise: of the objective, or of the limit of a residual; of a single
/// damper, without a box; and of the largest tolerance itself.
constexpr double largest_excess = 5e-3;
constexpr double largest_excess_of_one = 2e-2;
/// The gain without which a notch is left out.
constexpr double least_gain = 0.01;

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// As fine as it may be for its cost, in values of records, and not finer than of use.
std::optional<test::DenseBox> best_box(const RecordDesignRequest& task, bool constant) {
  constexpr double most_values = 5e9;
  const test::DenseBoxes truth(task);
  double values = 0;
  for (const design::SuiteRecord& each : task.cases.front().records) {
    values += static_cast<double>(each.record.values.size());
  }
  int steps = constant ? 32 : 6;
  while (steps > 2 && values * static_cast<double>(truth.points(steps, constant)) > most_values) {
    --steps;
  }
  return truth.best(steps, constant);
}

/// What a scan found that is better than a design, or as good.
struct Comparison {
  std::optional<test::DenseBox> best;
  double excess{0};  ///< of the design, in units of what it is promised to be within
  double allowed{largest_excess};
};

Comparison against_best(const RecordDesign& design) {
  const RecordDesignRequest& task = design.request;
  Comparison result{best_box(task, true)};
  std::optional<test::DenseBox>& best = result.best;
  if (task.delta->high > 0) {
    const auto with_notch = best_box(task, false);
    if (with_notch && (!best || with_notch->value < best->value * (1 - least_gain))) {
      best = with_notch;
    }
  }
  const double found =
      design.finding ? design.nearest.figures.front().*minimised(task).value : HUGE_VAL;
  if (best) {
    const bool of_limit = task.objective == design::SuiteObjective::residual;
    result.excess =
        (found - best->value) / (of_limit ? *task.cases.front().limits.residual : best->value);
  }
  result.allowed = task.tolerance.f.above > 0 ? largest_excess : largest_excess_of_one;
  return result;
}

/// Boxes that are larger than that of the design, in ever larger steps until there is none.
Comparison against_larger(const RecordDesign& design) {
  Comparison result;
  const double found = design.finding ? design.largest_tolerance.value() : 0;
  constexpr double whole = 0.95;
  for (const bool constant : {true, false}) {
    const bool needs_gain = !constant && design.finding && design.nearest.damper.delta == 0;
    for (double more = 1.01 * largest_excess;; more *= 2) {
      const double now = found * (needs_gain ? 1 + least_gain : 1) + more;
      RecordDesignRequest task = design.request;
      task.tolerance = {{now, now}, {now, now}, {now, now}, {}};
      const auto best = now < whole && (constant || task.delta->high > 0) ? best_box(task, constant)
                                                                          : std::nullopt;
      if (!best) {
        break;
      }
      if (more > result.excess) {
        result.best = best;
        result.excess = more;
      }
    }
  }
  return result;
}

/// Whether the dense scan of one row of the table does not beat its design.
bool compare(const NamedSuite& suite, double tolerance) {
  RecordDesignRequest request = suite.request;
  request.tolerance = {{tolerance, tolerance}, {tolerance, tolerance}, {tolerance, tolerance}, {}};
  const double begin = processor_seconds();
  const RecordDesign design = design::design(request);
  const double seconds = processor_seconds() - begin;
  const bool robust = request.objective == design::SuiteObjective::robust;
  const Comparison scan = robust ? against_larger(design) : against_best(design);
  const bool good = scan.excess <= scan.allowed;
  const design::SuiteDamper& damper = design.nearest.damper;
  const double objective = robust ? design.largest_tolerance.value_or(0)
                                  : design.nearest.figures.front().*minimised(request).value;
  fmt::print(
      "| {} | {} | {} | {} | {:.5f} | {:.2f} mm | {:.1f} mm | {:.3f} s | {} | {} | {:.1f} s "
      "| {:.1f} s |\n",
      suite.part, suite.name, notch_words(request),
      robust ? "largest" : fmt::format("{}", tolerance), damper.f, 1e3 * damper.delta / metre,
      1e3 * damper.width / metre, 2.8 / damper.p,
      design.finding ? fmt::format("{:.5f}", objective) : "none",
      scan.best || (robust && design.finding)
          ? fmt::format("{:.2g} %{}", 100 * scan.excess, good ? "" : " FAILS")
          : "the scan has none",
      seconds, processor_seconds() - begin - seconds);
  std::fflush(stdout);
  if (!good) {
    const auto& [f, delta, period, width] = scan.best->design;
    fmt::print(stderr,
               "the scan has {:.6g} at f = {:.6g}, delta = {:.6g} ({:.3f} mm), period {:.4f} s, "
               "width {:.2f} mm\n",
               robust ? objective + scan.excess : scan.best->value, f, delta, 1e3 * delta / metre,
               2.8 * period, 1e3 * width / metre);
  }
  return good;
}

int run(int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2 || words[0] != "truth") {
    fmt::print(stderr,
               "usage: stillpoint_suites truth RECORDS_FOLDER [WORD...]\n"
               "only rows that contain each WORD: robust, exact, recorded, seven...\n");
    return 2;
  }
  const char* const more = std::getenv("STILLPOINT_RECORDS");
  fmt::print(
      "| part | suite | notch | tolerance | f | delta | width | period | value | excess over "
      "the scan's best | search | scan |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const NamedSuite& suite :
       suites(words[1], more != nullptr ? std::optional<std::string>(more) : std::nullopt)) {
    const std::string row = suite.part + "; " + suite.name + "; " + notch_words(suite.request);
    if (!std::all_of(words.begin() + 2, words.end(), [&](const std::string& word) {
          return row.find(word) != std::string::npos;
        })) {
      continue;
    }
    for (const double tolerance : suite.tolerances) {
      good = compare(suite, tolerance) && good;
    }
  }
  return good ? 0 : 1;
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
