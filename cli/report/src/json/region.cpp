// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/region_fields.hpp"
#include "json/schema.hpp"

#include <stillpoint/report/schemas.hpp>

#include <algorithm>

namespace stillpoint::report {

std::optional<Interval> side_of(const design::BoxShape& shape, double tolerance, double below,
                                double above) {
  return shape == design::BoxShape{}
             ? std::nullopt
             : std::optional(Interval{1 - tolerance * below, 1 + tolerance * above});
}

std::optional<Interval> ShownInput::side(double design::BoxShape::*below,
                                         double design::BoxShape::*above) const {
  const design::BoxShape& shape = task.limits.shape;
  return side_of(shape, task.limits.tolerance, shape.*below, shape.*above);
}

double ShownInput::tolerance() const {
  const auto& [f_low, f_high, delta_low, delta_high] = task.limits.shape;
  return task.limits.tolerance * std::min({f_low, f_high, delta_low, delta_high});
}

std::optional<double> ShownInput::k() const {
  return task.pulse ? std::optional(design::peak_load(*task.pulse)) : std::nullopt;
}

std::optional<double> ShownInput::lambda() const {
  return task.pulse ? std::optional(design::angular_frequency(*task.pulse)) : std::nullopt;
}

std::optional<Interval> range_of(const std::optional<double>& low,
                                 const std::optional<double>& high) {
  return low && high ? std::optional(Interval{*low, *high}) : std::nullopt;
}

std::optional<std::vector<std::string_view>> conflict_of(const design::Region& region) {
  using Names = std::vector<std::string_view>;
  switch (region.conflict) {
    case design::Conflict::none:
      break;
    case design::Conflict::amplitude_against_return:
      return Names{"amplitude", "return"};
    case design::Conflict::amplitude_against_dead_zone:
      return Names{"amplitude", "dead_zone"};
    case design::Conflict::amplitude_against_limit:
      return Names{"amplitude", region.limit->constraint};
    case design::Conflict::limit_alone:
      return Names{region.limit->constraint};
    case design::Conflict::stop_against_start:
      return Names{"stop", "start"};
    case design::Conflict::stop_against_limit:
      return Names{"stop", region.limit->constraint};
    case design::Conflict::no_arrival:
      return Names{"stop", "arrivals"};
    case design::Conflict::narrower_than_rounding:
      return Names{"rounding"};
  }
  return std::nullopt;
}

std::optional<ShownServed> served(const std::optional<design::WorksFor>& works_for,
                                  const ShownTask& task) {
  return works_for ? std::optional(ShownServed{*works_for, task.pulse.has_value()}) : std::nullopt;
}

std::optional<std::vector<design::Hits>> hits_of(const ShownTask& task,
                                                 const std::optional<double>& f,
                                                 const std::optional<double>& delta) {
  if (!f || !delta) {
    return std::nullopt;
  }
  return task.pulse
             ? shown_strengths(pulse_problem(task.problem, *task.pulse, task.ranges), *f, *delta)
             : shown_hits(task.problem, *f, *delta);
}

std::optional<ShownPractice> practice_at_ends(const ShownTask& task,
                                              const std::optional<design::Practice>& own,
                                              const std::optional<double>& f,
                                              const std::optional<double>& delta) {
  const ToldPractice told = told_practice(task, own, f.value_or(0), delta.value_or(0));
  return told.at_ends && told.lines ? std::optional(ShownPractice{{*told.lines}, {}})
                                    : std::nullopt;
}

std::optional<std::vector<ShownPart>> parts_of(const std::optional<Catalogue>& catalogue,
                                               const ShownTask& task) {
  if (!catalogue) {
    return std::nullopt;
  }
  std::vector<ShownPart> parts;
  parts.reserve(catalogue->parts.size());
  for (const design::RatedPart& rated : catalogue->parts) {
    parts.push_back({rated, task});
  }
  return parts;
}

std::optional<double> in_metres(const Physical& physical, const std::optional<double>& length) {
  return physical && length ? std::optional(*length * physical->scales.length_m) : std::nullopt;
}

std::optional<std::string> file_of(const std::optional<Catalogue>& catalogue) {
  return catalogue ? std::optional(spelled_out(catalogue->file)) : std::nullopt;
}

std::optional<std::string> if_any(std::string text) {
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

namespace {

constexpr auto region_name = std::to_array<std::string_view>({"stillpoint/region-report/1"});

struct RegionInput : ShownInput {
  const std::optional<double>& f;
  const std::optional<double>& delta;
};

constexpr auto region_input_fields = std::tuple{
    Field{"f", [](const RegionInput& now) { return now.f; }},
    Field{"delta", [](const RegionInput& now) { return now.delta; }},
    Field{"catalogue", [](const RegionInput& now) { return file_of(now.catalogue); }, "the file"}};

nlohmann::ordered_json own_json(const RegionInput& input) {
  return input_json(input, region_input_fields);
}
nlohmann::ordered_json own_schema(const RegionInput* /*input*/) {
  return input_schema<RegionInput>(region_input_fields);
}

RegionInput region_input(const RegionReport& report) {
  const design::RegionRequest& request = report.request;
  return {{task_of(report), request.pulse ? std::nullopt : std::optional(request.problem.v0),
           report.catalogue},
          request.f,
          request.delta};
}

std::optional<ShownPractice> point_practice(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const auto& lines = report.answer.practice;
  return lines ? std::optional(ShownPractice{
                     {*lines}, design::impulses({problem.p, *f, *delta}, *report.answer.response)})
               : std::nullopt;
}

}  // namespace

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::RegionReport> = [] {
  using namespace report;
  using Now = RegionReport;
  using design::RegionAnswer;
  return std::tuple_cat(
      head_fields<Now, region_name>, told_fields<Now>,
      std::tuple{
          Field{"input", &region_input},
          Field{"region",
                [](const Now& now) -> const design::RegionVerdict& { return now.answer; }},
          Field{"strips", in(&Now::answer, &RegionAnswer::strips),
                "one for each arrival up to input.arrivals at which some damper can stop"},
          Field{"delta1_published", in(&Now::answer, &RegionAnswer::delta1_published),
                "at the given f"},
          Field{"delta1_exact", in(&Now::answer, &RegionAnswer::delta1_exact),
                "null if the motion does not return, for a hit with f > f3"},
          Field{"admissible", in(&Now::answer, &RegionAnswer::admissible),
                "of the given point; null without one"},
          Field{"tolerance", in(&Now::answer, &RegionAnswer::tolerance),
                "the largest that the point allows"},
          Field{"arrival", in(&Now::answer, &RegionAnswer::arrival),
                "at which an admissible point stops the mass; else, and with a pulse, null",
                at_least_one},
          Field{"constraints", in(&Now::answer, &RegionAnswer::constraints)},
          Field{"works_for",
                [](const Now& now) { return served(now.answer.works_for, task_of(now)); },
                "around the given v0, or k of a pulse, and p, each with the other as given: where "
                "the "
                "point itself meets every requirement, both ends included"},
          Field{"hits",
                [](const Now& now) {
                  return hits_of(task_of(now), now.request.f, now.request.delta);
                },
                "how the motion ends, for every v0 from 0 to twice the given one"},
          Field{"practice", &point_practice},
          Field{"practice_worst",
                [](const Now& now) {
                  return practice_at_ends(task_of(now), now.answer.practice, now.request.f,
                                          now.request.delta);
                },
                "each figure at the end of the ranges where it is worst; null without ranges and "
                "with "
                "a pulse"},
          Field{"catalogue", [](const Now& now) { return parts_of(now.catalogue, task_of(now)); },
                "every part, best first; null without a catalogue"},
          Field{"physical", [](const Now& now) { return physical_of(now); },
                "in the units at the ends of the names; null with dimensionless input"}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

nlohmann::ordered_json json(const RegionReport& report) {
  return object_json(report);
}

nlohmann::ordered_json region_schema() {
  return document_schema(region_name.front(), "region --json", dimensionless_numbers,
                         schema_of<RegionReport>());
}

}  // namespace stillpoint::report
