// SPDX-License-Identifier: MIT
#include "sweep_report.hpp"

#include "text_sections.hpp"
#include "version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace stillpoint::cli {

namespace {

using nlohmann::ordered_json;
using sweep::Quantity;
using sweep::sweep_outcome_count;
using sweep::sweep_outcome_name;
using sweep::SweepKind;
using sweep::SweepSpec;
using sweep::SweepState;
using sweep::SweepSummary;

double rate(const SweepSummary& summary) {
  constexpr double least_s = 1e-6;
  return static_cast<double>(summary.state.rows - summary.resumed_at) /
         std::max(summary.wall_time_s, least_s);
}

constexpr std::array<std::string_view, sweep_outcome_count> outcome_labels{
    "stop at x = 0",   "stop in dead zone", "never stop",
    "caught at start", "running",           "over the limit"};

ordered_json outcomes_json(const SweepState& state) {
  ordered_json counts;
  for (std::size_t i = 0; i < sweep_outcome_count; ++i) {
    counts[std::string(sweep_outcome_name(i))] = state.outcomes[i];
  }
  return counts;
}

}  // namespace

std::string sweep_json(const SweepSpec& spec, const SweepSummary& summary) {
  const bool design = spec.kind == SweepKind::design;
  ordered_json columns = ordered_json::array();
  for (const Quantity column : spec.columns) {
    columns.push_back(name(column));
  }
  const SweepState& state = summary.state;
  const ordered_json report{
      {"schema", "stillpoint/sweep-report/1"},
      {"program", {{"name", "stillpoint"}, {"version", program_version()}}},
      {"kind", name(spec.kind)},
      {"output", {{"file", *spec.output}, {"format", name(spec.format)}, {"columns", columns}}},
      {"rows", state.rows},
      {"outcomes", design ? ordered_json(nullptr) : outcomes_json(state)},
      {"feasible", design ? ordered_json(state.feasible) : ordered_json(nullptr)},
      {"resumed_at", summary.resumed_at},
      {"threads", spec.threads},
      {"wall_time_s", summary.wall_time_s},
      {"rows_per_s", rate(summary)}};
  constexpr int indent = 2;
  return report.dump(indent) + "\n";
}

std::string sweep_text(const SweepSpec& spec, const SweepSummary& summary,
                       const std::optional<std::string>& title, Style style) {
  const SweepState& state = summary.state;
  Page page(style);
  add_title(page, "Sweep", title);
  page.section("Rows");
  page.row("file", *spec.output);
  page.row("rows", fmt::format("{}", state.rows));
  if (summary.resumed_at > 0) {
    page.row("resumed at", fmt::format("{}", summary.resumed_at));
  }
  page.row("time", fmt::format("{:.4g} s, {:.3g} rows/s on {} thread{}", summary.wall_time_s,
                               rate(summary), spec.threads, spec.threads == 1 ? "" : "s"));
  if (spec.kind == SweepKind::design) {
    page.section("Designs");
    page.row("feasible", fmt::format("{}", state.feasible));
    page.row("infeasible", fmt::format("{}", state.rows - state.feasible));
    return page.text();
  }
  page.section("Outcomes");
  for (std::size_t i = 0; i < sweep_outcome_count; ++i) {
    if (state.outcomes[i] > 0) {
      page.row(outcome_labels[i], fmt::format("{}", state.outcomes[i]));
    }
  }
  return page.text();
}

}  // namespace stillpoint::cli
