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
      "[data/reference](../data/reference/README.md), which ship with the scripts that made them. "
      "*Error of the end* is the error of the stop time of a free motion, and the larger of the "
      "errors of x and v at the end of a forced one. *Counts* are passages, turning points and "
      "sticks; a free motion must also stop at x = 0. A setting with a wrong count is marked as "
      "wrong and meets no bound.\n\n"
      "Times are medians of {} batches of about {:.0f} ms, with their quartiles; the methods take "
      "turns batch by batch. A call that takes more than {} s is timed once, without quartiles. "
      "All runs use one thread.\n\n"
      "The absolute tolerance of a peer is its setting in every scene, although the size of the "
      "motion ranges from 0.1 to 13. The cheapest setting that meets a bound counts. There, a "
      "tolerance relative to the peak would change the steps of dopri5 by 17 % at most, up or "
      "down, except on S3 at 1e-10, which dopri5 then does not reach.\n\n"
      "All peers except the regularised model follow the same rules of passage, turn and stick and "
      "integrate in between. They get every advantage: step lengths carry over from one piece to "
      "the next, steps end exactly at the samples of a record, W is looked up without a search, "
      "and Newton's method finds the events of a peer without dense output. The bump of the "
      "regularised model is switched on after the start, and motion within the bump counts as "
      "neither a turn nor a passage. All are compiled with the same flags.\n\n",
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
  how(text, comparison);
  free_kernel(text, comparison);
  add(text, "## The scenes\n\n");
  for (const SceneRows& scene : comparison.scenes) {
    all_rows(text, scene);
  }
  text.resize(text.size() - 1);  // a single newline at the end
  return fmt::to_string(text);
}

}  // namespace stillpoint::bench
