// SPDX-License-Identifier: MIT
#include <stillpoint/design/record_findings.hpp>

#include "record/suite_request.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/design/motion_findings.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>

namespace stillpoint::design {

namespace {

using enum FindingKind;
using records::Dimension;

/// The load that the damper is compared with: combined as its figures.
double load_of(const LoadCase& load_case, double p) {
  double sum = 0;
  for (const SuiteRecord& record : load_case.records) {
    sum += peak_load(record);
  }
  return is_mean(load_case) ? sum / static_cast<double>(load_case.records.size())
                            : peak_load(load_case, p);
}

bool isolates(const RecordDesign& result, std::size_t in_case) {
  const auto& [damper, figures] = result.nearest;
  const LoadCase& load_case = result.request.cases[in_case];
  return load_case.v0 || figures.empty() ||
         figures[in_case].acceleration <= hardly_less * load_of(load_case, damper.p);
}

/// Of one case, which is named if there are several.
Finding& add(std::vector<Finding>& all, FindingKind kind, const LoadCase& load_case) {
  Finding& finding = all.emplace_back(kind);
  return load_case.name.empty() ? finding : finding.tell("case", load_case.name);
}

/// A notch that is narrow for what it takes; where nothing limits or minimises that. Of several
/// cases the one that feels most.
void add_felt(std::vector<Finding>& all, const RecordDesign& result) {
  constexpr double far_more = 2;  // times
  const SuiteDamper& damper = result.nearest.damper;
  const TaskFigures& worst = result.nearest.figures;
  const std::vector<LoadCase>& cases = result.request.cases;
  const auto outside = [&](std::size_t i) {
    return damper.p * damper.p * worst[i].peak + damper.f;
  };
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (damper.width > 0 && !cases[i].limits.acceleration && worst[i].peak > 0 &&
        result.finding->point.figures[i].peak > 0 &&
        result.request.objective != SuiteObjective::acceleration &&
        worst[i].acceleration > far_more * outside(i) &&
        (!most || worst[i].acceleration > worst[*most].acceleration)) {
      most = i;
    }
  }
  if (most) {
    add(all, felt_in_notch, cases[*most])
        .add(transmitted_name, worst[*most].acceleration, Dimension::gravities)
        .add("outside", outside(*most), Dimension::gravities);
  }
}

void add_motions(std::vector<Finding>& all, const RecordDesign& result, std::size_t in_case) {
  const LoadCase& load_case = result.request.cases[in_case];
  const std::vector<ForcedResponse>& responses = result.finding->responses[in_case];
  const double p = result.nearest.damper.p;
  const bool moves = result.finding->point.figures[in_case].peak > 0;
  if (!moves) {
    Finding& still = add(all, never_moves, load_case);
    if (result.finding->box.worst[in_case].peak > 0) {
      still.tell("damper", "exact");
    }
    if (load_case.v0) {
      still.tell("by", "notch");
    } else {
      still.add("largest_load", peak_load(load_case, p), Dimension::gravities);
    }
    if (load_case.of_records()) {
      still.count("records", responses.size());
    } else if (load_case.pulse) {
      const double friction = result.nearest.damper.f * result.request.breakaway;
      still.tell("by", friction < peak_load(load_case, p) ? "notch" : "friction");
    }
  }
  if (!isolates(result) && !load_case.v0) {
    Finding& useless = add(all, does_not_isolate, load_case);
    useless.add(transmitted_name, result.nearest.figures[in_case].acceleration,
                Dimension::gravities);
    useless.add("largest_load", load_of(load_case, p), Dimension::gravities);
    if (!result.request.judges && result.request.objective != SuiteObjective::acceleration &&
        !load_case.limits.acceleration) {
      useless.tell("asked", "nothing");
    }
  }
  std::size_t count = 0;
  double most = 0;
  for (const ForcedResponse& response : responses) {
    count += response.locks() ? 1U : 0U;
    most = std::max(most, response.largest_load_while_locked.value_or(0));
  }
  if (count > 0 && moves) {
    Finding& lock = add(all, locks, load_case);
    lock.add("largest_load_while_locked", most, Dimension::gravities);
    if (load_case.of_records()) {
      lock.count("records", count).count("of_records", responses.size());
    } else {
      lock.add("pulses", static_cast<double>(count));
    }
  }
  const SuiteDamper& damper = result.nearest.damper;
  if (load_case.pulse && damper.delta > 0 && damper.width == 0 && !result.request.hold && moves) {
    const double peak = responses.front().peak_amplitude;
    const double residual = load_case.limits.residual.value_or(0);
    const Finding late =
        late_notch(oscillator_of(result.request, damper), excitation(*load_case.pulse),
                   (load_case.weakest > 0 ? load_case.weakest : 1) * peak_load(*load_case.pulse),
                   peak, residual > 0 ? residual : rest_share * peak,
                   !result.request.judges && !result.request.delta_max);
    if (result.finding->admissible) {
      Finding& added = add(all, late.kind, load_case);
      std::ranges::copy(late.values, std::back_inserter(added.values));
    }
  }
  // After a hit, as everywhere in the paper, it does at every notch.
  if (const double jump = result.finding->box.worst[in_case].jump; jump > 0 && !load_case.v0) {
    add(all, jolts, load_case).add("jump", jump, Dimension::velocity);
  }
}

/// For each limit that a mean meets, the records that exceed it.
void add_hidden(std::vector<Finding>& all, const RecordDesign& result, std::size_t in_case) {
  const LoadCase& load_case = result.request.cases[in_case];
  const std::vector<ForcedResponse>& responses = result.finding->responses[in_case];
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& limit = load_case.limits.*kind.limit;
    if (!limit || !is_mean(load_case)) {
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
        load_case.records[static_cast<std::size_t>(worst - responses.begin())];
    add(all, records_exceed_limit, load_case)
        .tell("figure", kind.words)
        .tell("record", record.name)
        .add("scale", record.scale)
        .add("value", value(*worst), kind.dimension)
        .add("limit", limit, kind.dimension)
        .count("records", static_cast<std::size_t>(beyond))
        .count("of_records", responses.size());
  }
}

/// What a period, or a scale of the records, that is off breaks: the limit that is exceeded most.
void add_outlook(std::vector<Finding>& all, const RecordDesign& result, std::string_view input,
                 const TaskFigures& worst) {
  const std::vector<LoadCase>& cases = result.request.cases;
  std::size_t in_case = 0;
  const SuiteFigureKind* figure = nullptr;
  bool unsettled = false;
  std::size_t broken = 0;
  double most = 0;
  for (std::size_t i = 0; i < cases.size() && !unsettled; ++i) {
    unsettled = !worst[i].settled;
    in_case = unsettled ? i : in_case;
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      const double value = worst[i].*kind.value;
      const double limit = (cases[i].limits.*kind.limit).value_or(HUGE_VAL);
      broken += value > limit ? 1U : 0U;
      // A passage more is told by how far off the mass then rests, if that is told at all.
      const double times = kind.limit == &SuiteLimits::passages ? 1 : value / limit;
      if (value > limit && (figure == nullptr || times > most) && !unsettled) {
        most = times;
        in_case = i;
        figure = &kind;
      }
    }
  }
  if (figure == nullptr && !unsettled) {
    return;
  }
  const LoadCase& load_case = cases[in_case];
  Finding& finding = add(all, fails_if_off, load_case);
  finding.tell("input", input == "scale" && !load_case.of_records() ? "load" : input);
  finding.add("off", SuiteOutlook::off);
  if (!result.request.tolerance.exact()) {
    finding.tell("besides", "tolerance");
  }
  finding.tell("figure", unsettled ? "rest" : figure->words);
  if (!unsettled) {
    finding.add("value", worst[in_case].*figure->value, figure->dimension);
    finding.add("limit", load_case.limits.*figure->limit, figure->dimension);
    if (broken > 1) {
      finding.count("others", broken - 1);
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
  const std::vector<LoadCase>& cases = result.request.cases;
  bool any = std::ranges::all_of(cases, [](const LoadCase& each) { return each.v0.has_value(); });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    any = any || (!cases[i].v0 && isolates(result, i));
  }
  return any;
}

bool is_mean(const LoadCase& load_case) {
  return load_case.combine.value() == Combine::mean && load_case.records.size() > 1;
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
  const RecordFinding& found = *result.finding;
  const SuiteDamper& damper = found.point.damper;
  add_failed(all, found.cross_check);
  const std::vector<LoadCase>& cases = result.request.cases;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    add_motions(all, result, i);
    add_hidden(all, result, i);
  }
  const auto& printed = result.request.printed;
  if (printed && printed->time && damper.f > 1) {  // without units f has no weight
    all.emplace_back(friction_above_weight).add("f", damper.f);
  }
  add_felt(all, result);
  if (found.box.samples == 1 && !result.largest_tolerance && found.admissible) {
    all.emplace_back(exact_only);
  }
  if (!asked.judges) {
    add_notch(all, result, asked);
  }
  // Beyond the largest box of hits and pulses everything fails; works_for says what else does.
  const bool largest_of_hits =
      result.largest_tolerance && std::ranges::none_of(cases, &LoadCase::of_records);
  if (found.admissible && !largest_of_hits) {
    add_outlook(all, result, "period", found.outlook.period);
    add_outlook(all, result, "scale", found.outlook.scale);
  }
  return all;
}

}  // namespace stillpoint::design
