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
      "`./dev bench --update-docs` writes this page; [performance.json](performance.json) has "
      "every "
      "setting of every method, with its errors, counts and quartiles, and what each method is. "
      "[performance.html](performance.html) shows the values under the pointer.\n\n"
      "![Time against error, one panel per scene](performance.svg)\n\n"
      "Measured {} on {}, {} cores, {}: {}, `{}` for all methods, with `-fno-tree-slp-vectorize` "
      "for the kernel, {}.\n\n",
      machine.date, machine.processor, machine.cores, machine.system, machine.compiler,
      machine.flags, fmt::join(machine.libraries, ", "));
}

void how(Text& text, const Comparison& comparison) {
  add(text,
      "## How it was measured\n\n"
      "Errors are absolute, in the units of the scenes, against "
      "[data/reference](../data/reference/README.md). A setting with a wrong count of passages, "
      "turns or sticks is wrong at any bound. Times are medians of {} batches of about {:.0f} ms "
      "on "
      "one thread, the methods in turn; a call of more than {} s is timed once.\n\n"
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
