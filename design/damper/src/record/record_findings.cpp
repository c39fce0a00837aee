// SPDX-License-Identifier: MIT
#include <stillpoint/design/record_findings.hpp>

#include "record/suite_request.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/design/motion_findings.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace stillpoint::design {

namespace {

using enum FindingKind;
using records::Dimension;

void add_count(Finding& finding, std::string_view name, std::size_t count) {
  finding.values.push_back({name, static_cast<std::int64_t>(count)});
}

/// The load that the damper is compared with: combined as its figures.
double load_of(const RecordDesignRequest& task) {
  double sum = 0;
  for (const SuiteRecord& record : task.records) {
    sum += peak_load(record);
  }
  return is_mean(task) ? sum / static_cast<double>(task.records.size()) : peak_load(task.records);
}

void add_motions(std::vector<Finding>& all, const RecordDesign& result) {
  const std::vector<ForcedResponse>& responses = result.finding->responses;
  if (result.finding->point.figures.peak == 0) {
    Finding& still = all.emplace_back(never_moves);
    still.add("largest_load", peak_load(result.request.records), Dimension::gravities);
    add_count(still, "records", responses.size());
  }
  if (!isolates(result)) {
    Finding& useless = all.emplace_back(does_not_isolate);
    useless.add(transmitted_name, result.nearest.figures.acceleration, Dimension::gravities);
    useless.add("largest_load", load_of(result.request), Dimension::gravities);
  }
  std::size_t count = 0;
  double most = 0;
  for (const ForcedResponse& response : responses) {
    count += response.locks() ? 1U : 0U;
    most = std::max(most, response.largest_load_while_locked.value_or(0));
  }
  if (count > 0 && result.finding->point.figures.peak > 0) {
    Finding& lock = all.emplace_back(locks);
    lock.add("largest_load_while_locked", most, Dimension::gravities);
    add_count(lock, "records", count);
    add_count(lock, "of_records", responses.size());
  }
  if (const double jump = result.finding->box.worst.jump; jump > 0) {
    all.emplace_back(jolts).add("jump", jump, Dimension::velocity);
  }
}

/// For each limit that a mean meets, the records that exceed it.
void add_hidden(std::vector<Finding>& all, const RecordDesign& result) {
  const std::vector<ForcedResponse>& responses = result.finding->responses;
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& limit = result.request.limits.*kind.limit;
    if (!limit || !is_mean(result.request)) {
      continue;
    }
    const auto value = [&](const ForcedResponse& of) { return suite_figures(of).*kind.value; };
    const auto beyond = std::ranges::count_if(
        responses, [&](const ForcedResponse& of) { return value(of) > *limit; });
    if (beyond == 0) {
      continue;
    }
    const auto worst = std::ranges::max_element(responses, {}, value);
    const SuiteRecord& record =
        result.request.records[static_cast<std::size_t>(worst - responses.begin())];
    Finding& finding = all.emplace_back(
        records_exceed_limit,
        std::vector<FindingValue>{{"figure", std::string(kind.words)}, {"record", record.name}});
    finding.add("scale", record.scale);
    finding.add("value", value(*worst), kind.dimension);
    finding.add("limit", limit, kind.dimension);
    add_count(finding, "records", static_cast<std::size_t>(beyond));
    add_count(finding, "of_records", responses.size());
  }
}

/// What a period, or a scale of the records, that is off breaks.
void add_outlook(std::vector<Finding>& all, const RecordDesign& result, std::string_view input,
                 const SuiteFigures& worst) {
  const auto add = [&](std::string_view figure) -> Finding& {
    Finding& finding = all.emplace_back(fails_if_off);
    finding.values.push_back({"input", std::string(input)});
    finding.add("off", SuiteOutlook::off);
    finding.values.push_back({"figure", std::string(figure)});
    return finding;
  };
  if (!worst.settled) {
    add("rest");
    return;
  }
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& limit = result.request.limits.*kind.limit;
    if (limit && worst.*kind.value > *limit) {
      Finding& finding = add(kind.words);
      finding.add("value", worst.*kind.value, kind.dimension);
      finding.add("limit", limit, kind.dimension);
    }
  }
}

/// Constant friction alone was searched, or found to be as good.
void add_notch(std::vector<Finding>& all, const RecordDesign& result,
               const RecordDesignRequest& asked) {
  if (!counts_the_notch(asked) && !(asked.delta && asked.delta->high == 0)) {
    all.emplace_back(notch_needs_width);
  } else if (result.finding && result.request.delta->high > 0 &&
             result.finding->point.damper.delta == 0 &&
             !result.search.interrupted) {  // which leaves the notch untried
    all.emplace_back(notch_gains_little);
  }
}

}  // namespace

bool isolates(const RecordDesign& result) {
  constexpr double hardly = 0.95;
  return result.nearest.figures.acceleration <= hardly * load_of(result.request);
}

bool is_mean(const RecordDesignRequest& task) {
  return task.combine.value() == Combine::mean && task.records.size() > 1;
}

std::vector<Finding> findings_of(const RecordDesign& result, const RecordDesignRequest& asked) {
  std::vector<Finding> all;
  if (result.search.interrupted) {
    all.emplace_back(interrupted);
  }
  if (!result.finding) {
    add_notch(all, result, asked);
    return all;
  }
  const auto& [point, responses, box, outlook, check] = *result.finding;
  add_failed(all, check);
  add_motions(all, result);
  add_hidden(all, result);
  const auto& printed = result.request.printed;
  if (printed && printed->time && point.damper.f > 1) {  // without units f has no weight
    all.emplace_back(friction_above_weight).add("f", point.damper.f);
  }
  if (box.samples == 1) {
    all.emplace_back(exact_only);
  }
  add_notch(all, result, asked);
  add_outlook(all, result, "period", outlook.period);
  add_outlook(all, result, "scale", outlook.scale);
  return all;
}

}  // namespace stillpoint::design
