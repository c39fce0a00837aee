// SPDX-License-Identifier: MIT
#include "reports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace stillpoint::bench {

namespace {

/// A report under construction.
using Text = fmt::memory_buffer;

template <class... Arguments>
void add(Text& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

/// Microseconds with three digits.
std::string microseconds(double seconds) {
  const double us = seconds * 1e6;
  const int decimals = us < 1 ? 3 : us < 10 ? 2 : us < 100 ? 1 : 0;
  return fmt::format("{:.{}f}", us, decimals);
}

/// A round factor: more digits would be lost in the spread.
std::string factor(double ratio) {
  return fmt::format("{:.{}f}", ratio, ratio < 10 ? 1 : 0);
}

std::string error(double value) {
  return value == 0 ? std::string("0") : fmt::format("{:.1e}", value);
}

void heading(Text& text, const Comparison& comparison) {
  const Machine& machine = comparison.machine;
  add(text,
      "# Speed against error\n\n"
      "This page compares the time of one motion in stillpoint and in other integrators, for the "
      "same error. "
      "`./dev bench --update-docs` writes this page; [performance.json](performance.json) has "
      "every setting of every method, with its errors, counts and quartiles, and what each method "
      "is. [performance.html](performance.html) shows the values under the pointer.\n\n"
      "![Time against error, one panel per scene](performance.svg)\n\n"
      "Measured {} on {}, {} cores, {}: {}, `{}` for all methods, with `-fno-tree-slp-vectorize` "
      "for the kernel, {}.\n\n",
      machine.date, machine.processor, machine.cores, machine.system, machine.compiler,
      machine.flags, fmt::join(machine.libraries, ", "));
}

/// The best rival for each scene and bound.
void ratios(Text& text, const Comparison& comparison) {
  add(text,
      "## How many times faster\n\n"
      "The time of the fastest of dopri5, RK4 and rk8pd over the kernel's, each at its cheapest "
      "setting with right counts and no error above the bound.\n\n"
      "| scene | kernel, us | largest error | 1e-6 | 1e-8 | 1e-10 |\n|---|---|---|---|---|---|\n");
  for (const SceneRows& scene : comparison.scenes) {
    const Row& kernel = scene.kernel();
    add(text, "| {}: {} | {} | {} |", scene.scene.name, scene.scene.legend,
        microseconds(kernel.time.median), error(kernel.verdict.largest()));
    for (const double bound : {1e-6, 1e-8, 1e-10}) {
      if (const auto rival = best_rival(scene, bound)) {
        add(text, " {} ({}) |", factor(rival->ratio), rival->method->method.name);
      } else {
        add(text, " none |");
      }
    }
    add(text, "\n");
  }
  add(text, "\n");
}

/// The time of each peer at 1e-8, and how many of its settings have a wrong count.
void each_peer(Text& text, const Comparison& comparison) {
  add(text,
      "## Each peer at 1e-8\n\n"
      "Its time in multiples of the kernel's; in brackets, how many of its settings had a wrong "
      "count, if any.\n\n"
      "| scene |");
  const auto& methods = comparison.scenes.front().methods;
  for (std::size_t i = 1; i < methods.size(); ++i) {
    add(text, " {} |", methods[i].method.name);
  }
  add(text, "\n|---|");
  for (std::size_t i = 1; i < methods.size(); ++i) {
    add(text, "---|");
  }
  add(text, "\n");
  for (const SceneRows& scene : comparison.scenes) {
    add(text, "| {} |", scene.scene.name);
    for (std::size_t i = 1; i < scene.methods.size(); ++i) {
      const MethodRows& rows = scene.methods[i];
      const auto wrong = std::count_if(rows.rows.begin(), rows.rows.end(),
                                       [](const Row& row) { return !row.verdict.counts_right; });
      const Row* best = rows.cheapest(1e-8);
      add(text, " {}{} |",
          best != nullptr ? factor(best->time.median / scene.kernel().time.median)
                          : std::string("none"),
          wrong > 0 ? fmt::format(" ({}/{})", wrong, rows.rows.size()) : "");
    }
    add(text, "\n");
  }
  add(text, "\n");
}

/// Scene S6.
void many_dampers(Text& text, const Comparison& comparison) {
  const ManyDampers& many = comparison.many;
  const double entries = 1e4 * many.samples;
  add(text,
      "## S6: eleven records and 10^4 dampers\n\n"
      "The scan of a record design: the record of S5 in eleven scales and steps, a grid of f and "
      "Delta, one thread. One by one, {:.0f} dampers are run and the times scaled up. The peaks of "
      "RK4 are off by up to {}; {:.1f} % of its motions have a wrong count.\n\n"
      "| | whole scene, s | per sample and damper, ns | relative to the lanes "
      "|\n|---|---|---|---|\n",
      many.sampled, error(many.error_of_peak), 100 * many.wrong_counts);
  for (const Unit& unit : many.rows) {
    add(text, "| {} | {:.2f} | {:.2f} | {} |\n", unit.what, unit.seconds.median,
        unit.seconds.median / entries * 1e9,
        factor(unit.seconds.median / many.rows.front().seconds.median));
  }
  add(text, "\n");
}

/// The free kernel in each mode, and the square root.
void free_kernel(Text& text, const Comparison& comparison) {
  add(text,
      "## The free kernel and the square root\n\n"
      "A half-cycle is one square root that waits for the one before it. In ns, one motion of "
      "scene S2 at a time:\n\n");
  for (const Unit& unit : comparison.free_modes) {
    add(text, "- {}: {:.2f}\n", unit.what, unit.seconds.median * 1e9);
  }
  add(text, "\n");
}

void how(Text& text, const Comparison& comparison) {
  add(text,
      "## How it was measured\n\n"
      "Errors are absolute, in the units of the scenes, against "
      "[data/reference](../data/reference/README.md). A setting with a wrong count of passages, "
      "turns or sticks is wrong at any bound. Times are medians of {} batches of about {:.0f} ms "
      "on one thread, the methods in turn; a call of more than {} s is timed once.\n\n"
      "All follow the same rules of passage, turn and stick, except the regularised model, which "
      "smooths both frictions. The peers get their advantages: step lengths carry over from piece "
      "to piece, steps end at the samples of a record, and Newton's method finds the events where "
      "there is no dense output.",
      comparison.options.batches, comparison.options.batch_seconds * 1e3, comparison.options.slow);
#ifndef STILLPOINT_BENCH_CVODE
  add(text, " CVODE is measured only where SUNDIALS is installed; here it was not.");
#endif
  add(text, "\n\n");
}

}  // namespace

std::string markdown_report(const Comparison& comparison) {
  Text text;
  heading(text, comparison);
  ratios(text, comparison);
  each_peer(text, comparison);
  many_dampers(text, comparison);
  how(text, comparison);
  free_kernel(text, comparison);
  text.resize(text.size() - 1);  // a single newline at the end
  return fmt::to_string(text);
}

}  // namespace stillpoint::bench
