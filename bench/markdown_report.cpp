// SPDX-License-Identifier: MIT
#include "markdown_tables.hpp"
#include "reports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stillpoint::bench {

namespace {

void heading(Text& text, const Comparison& comparison) {
  const Machine& machine = comparison.machine;
  add(text,
      "# Speed against error\n\n"
      "`./dev bench` made this page; `./dev bench --update-docs` updates it.\n\n"
      "![Time against error, one panel per scene]"
      "(performance.svg)\n\n"
      "Open [performance.html](performance.html) in a browser to see the values under the "
      "pointer.\n\n"
      "| | |\n|---|---|\n"
      "| machine | {}, {} cores, {} |\n| compiler | {} |\n| flags of all methods | `{}` |\n"
      "| libraries | {} |\n| date | {} |\n\n",
      machine.processor, machine.cores, machine.system, machine.compiler, machine.flags,
      fmt::join(machine.libraries, ", "), machine.date);
}

void how(Text& text, const Comparison& comparison) {
  add(text,
      "## How it was measured\n\n"
      "Errors are absolute, in the dimensionless units of the scenes, against the tables in "
      "[data/reference](../data/reference/README.md). A setting with a wrong count of passages, "
      "turning points or sticks is wrong at any bound. Times are medians of {} batches of about "
      "{:.0f} ms, one thread; the methods take turns batch by batch. A call that takes more than "
      "{} s is timed once.\n\n"
      "All peers except the regularised model follow the same rules of passage, turn and stick. "
      "They get every advantage: step lengths carry over from one piece to the next, steps end "
      "exactly at the samples of a record, and Newton's method finds the events of a peer without "
      "dense output. The bump of the regularised model is switched on after the start, and motion "
      "within the bump counts as neither a turn nor a passage.\n\n",
      comparison.options.batches, comparison.options.batch_seconds * 1e3, comparison.options.slow);
  for (const MethodRows& rows : comparison.scenes.front().methods) {
    add(text, "- **{}**: {}.\n", rows.method.name, rows.method.what);
  }
#ifndef STILLPOINT_BENCH_CVODE
  add(text,
      "- **CVODE** is measured only where SUNDIALS is installed; on this machine it was not.\n");
#endif
  add(text, "\n");
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
  add(text,
      "[performance.json](performance.json) has every setting of every method, with quartiles and "
      "errors.\n\n");
  text.resize(text.size() - 1);  // a single newline at the end
  return fmt::to_string(text);
}

}  // namespace stillpoint::bench
