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
      "`./dev bench` made this page; `./dev bench --update-docs` makes it again.\n\n"
      "![Time against error, a panel a scene]"
      "(performance.svg)\n\n"
      "[performance.html](performance.html), opened in a browser, shows the same with the values "
      "under the pointer.\n\n"
      "| | |\n|---|---|\n"
      "| machine | {}, {} cores, {} |\n| compiler | {} |\n| flags, of all methods | `{}` |\n"
      "| libraries | {} |\n| date | {} |\n\n",
      machine.processor, machine.cores, machine.system, machine.compiler, machine.flags,
      fmt::join(machine.libraries, ", "), machine.date);
}

void how(Text& text, const Comparison& comparison) {
  add(text,
      "## How it was measured\n\n"
      "Errors are absolute, in the dimensionless units of the scenes, against the tables in "
      "[data/reference](../data/reference/README.md), which ship with the scripts that made them. "
      "*Error of the end* is that of the stop time of a free motion and the larger of those of x "
      "and v "
      "at the end of a forced one. *Counts* are passages, turning points, sticks; a free motion "
      "must "
      "stop at x = 0 as well. A wrong count is shown as wrong and reaches no bound.\n\n"
      "Times are medians of {} batches of some {:.0f} ms, with their quartiles; the methods take "
      "turns "
      "batch by batch. A call that takes more than {} s is timed once, without quartiles. One "
      "thread.\n\n"
      "The absolute tolerance of a peer is its setting in every scene, whatever the size of the "
      "motion, 0.1 to 13. Of all its settings the cheapest that reaches a bound is taken; there, "
      "a tolerance relative to the peak changes the steps of dopri5 by 17 % at most, to either "
      "side, but on S3 at 1e-10, which dopri5 then does not reach.\n\n"
      "All peers but the regularised model follow the same rules of passage, turn and stick and "
      "integrate in between. What makes them cheap is given to them: step lengths are carried on "
      "from "
      "one piece to the next, steps end at the samples of a record and not short of them, W is "
      "looked "
      "up without a search, and where a peer has no dense output its events are found by Newton's "
      "method. The bump of the regularised model is switched on after the start, and what the mass "
      "does within the bump is no turn and no passage. All are compiled with the same flags.\n\n",
      comparison.options.batches, comparison.options.batch_seconds * 1e3, comparison.options.slow);
  for (const MethodRows& rows : comparison.scenes.front().methods) {
    add(text, "- **{}**: {}.\n", rows.method.name, rows.method.what);
  }
#ifndef STILLPOINT_BENCH_CVODE
  add(text, "- **CVODE** is measured where SUNDIALS is installed; on this machine it was not.\n");
#endif
  add(text, "\n");
}

}  // namespace

std::string markdown_report(const Comparison& comparison) {
  Text text;
  heading(text, comparison);
  ratios(text, comparison);
  each_peer(text, comparison);
  how(text, comparison);
  free_kernel(text, comparison);
  add(text, "## The scenes\n\n");
  for (const SceneRows& scene : comparison.scenes) {
    all_rows(text, scene);
  }
  text.resize(text.size() - 1);  // one end of line at the end
  return fmt::to_string(text);
}

}  // namespace stillpoint::bench
