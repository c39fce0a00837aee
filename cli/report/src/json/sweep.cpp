// SPDX-License-Identifier: MIT
// A sweep with rows as JSON.

#include <stillpoint/report/sweep.hpp>

#include "json/head_fields.hpp"
#include "json/sweep_parts.hpp"

#include <algorithm>

namespace stillpoint {

/// Where the rows are.
template <>
inline constexpr auto fields<sweep::SweepSpec> =
    std::tuple{Field{"file", &sweep::SweepSpec::output, "null for rows in memory"},
               Field{"format", &sweep::SweepSpec::format},
               Field{"columns",
                     [](const sweep::SweepSpec& spec) {
                       return mapped(spec.columns, [&](auto column) {
                         return std::string(sweep::name(column, spec.units));
                       });
                     },
                     "", at_least_one}};

}  // namespace stillpoint

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

/// What `of` gives of each.
ordered_json outcome_object(const auto& of) {
  ordered_json counts;
  for (std::size_t i = 0; i < sweep::sweep_outcome_count; ++i) {
    counts[std::string(sweep::sweep_outcome_name(i))] = of(i);
  }
  return counts;
}

using sweep::SweepState;
using sweep::SweepSummary;

double rate(const SweepSummary& summary) {
  constexpr double least_s = 1e-6;
  return static_cast<double>(summary.state.rows - summary.resumed_at) /
         std::max(summary.wall_time_s, least_s);
}

constexpr auto sweep_name = std::to_array<std::string_view>({"stillpoint/sweep-report/1"});

ordered_json record_names_schema() {
  return {{"type", {"string", "array", "null"}}, {"items", {{"type", "string"}}}};
}

Printed<record_names_schema> record_names(const SweepReport& report) {
  ordered_json names = report.record ? ordered_json(*report.record) : ordered_json();
  if (!report.spec.records.empty()) {
    names = ordered_json(mapped(report.spec.records, &sweep::NamedRecord::name));
  }
  return {std::move(names)};
}

constexpr auto sweep_table = [] {
  using Now = SweepReport;
  using sweep::SweepSpec;
  constexpr auto kind = in(&Now::spec, &SweepSpec::kind);
  constexpr auto state = in(&Now::summary, &SweepSummary::state);
  return std::tuple_cat(
      head_fields<Now, sweep_name>,
      std::tuple{
          Field{"kind", kind}, Field{"output", &Now::spec},
          Field{"record", &record_names,
                "the file of the load; null of any other; with several records all of them, by "
                "the numbers in the column record"},
          Field{"part", in(&Now::spec, &SweepSpec::part), "null for a whole sweep"},
          Field{"rows", in(&Now::summary, &SweepSummary::state, &SweepState::rows),
                "all rows in the file"}},
      ended_fields(kind, state),
      std::tuple{Field{"resumed_at", in(&Now::summary, &SweepSummary::resumed_at),
                       "how many rows existed when this run began"},
                 Field{"threads", [](const Now& report) { return int{report.spec.threads}; }, "",
                       at_least_one},
                 Field{"wall_time_s", in(&Now::summary, &SweepSummary::wall_time_s),
                       "of this run only, like rows_per_s"},
                 Field{"rows_per_s", [](const Now& report) { return rate(report.summary); }}});
}();

}  // namespace

ordered_json outcomes_schema() {
  return object_schema(
      outcome_object([](std::size_t /*i*/) { return number_schema(true, Numbers::counts); }));
}

Printed<outcomes_schema> outcomes_of(const sweep::SweepState::Counts& counts) {
  return {outcome_object([&](std::size_t i) { return counts[i]; })};
}

ordered_json json(const SweepReport& report) {
  return object_by<sweep_table>(report);
}

ordered_json sweep_schema() {
  return report_schema<SweepReport>(sweep_table, sweep_name.front(), "sweep --output FILE --json");
}

}  // namespace stillpoint::report
