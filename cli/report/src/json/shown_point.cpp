// SPDX-License-Identifier: MIT
// What the reports of a design and a region of a hit or a pulse share.

#include "json/answer_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::report {

namespace {

IfRange range_of(const IfReal& low, const IfReal& high) {
  return low && high ? std::optional(Interval{*low, *high}) : std::nullopt;
}

bool has_ranges(const ShownTask& task) {
  return task.problem.p_high || task.problem.v0_low || task.ranges.k_low || task.ranges.lambda_high;
}

AskedTask asked_task(const ShownTask& task) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  AskedTask asked{.p = problem.p,
                  .beta = problem.beta,
                  .residual = problem.residual,
                  .v0_range = range_of(problem.v0_low, problem.v0),
                  .p_range = range_of(problem.p, problem.p_high),
                  .tolerance_f = side_of(limits.shape, limits.tolerance, f_low, f_high),
                  .tolerance_delta = side_of(limits.shape, limits.tolerance, delta_low, delta_high),
                  .arrivals = problem.arrivals,
                  .criterion = problem.criterion,
                  .tolerance = limits.tolerance * std::min({f_low, f_high, delta_low, delta_high}),
                  .limits = limits};
  if (pulse) {
    asked.pulse = design::name(*pulse);
    asked.k = design::peak_load(*pulse);
    asked.lambda = design::angular_frequency(*pulse);
    asked.k_range = range_of(ranges.k_low, asked.k);
    asked.lambda_range = range_of(asked.lambda, ranges.lambda_high);
  }
  return asked;
}

}  // namespace

IfRange side_of(const design::BoxShape& shape, double tolerance, double below, double above) {
  return shape == design::BoxShape{}
             ? std::nullopt
             : std::optional(Interval{1 - tolerance * below, 1 + tolerance * above});
}

ShownAnswer asked(const ShownTask& task, const design::RegionVerdict& region,
                  std::span<const design::Finding> findings) {
  ShownAnswer now{.units = task.physical,
                  .findings = findings,
                  .input = asked_task(task),
                  .largest_tolerance = region.largest_tolerance,
                  .region = &region,
                  .mends = region.mends};
  if (task.pulse) {
    now.duration = duration(design::excitation(*task.pulse));
  }
  now.cases.push_back({.load = {task.pulse ? design::name(*task.pulse) : "hit"}});
  return now;
}

BoxedDamper boxed_damper(const ShownTask& task, double f, double delta) {
  const double tolerance = task.limits.tolerance;
  const auto& [f_low, f_high, delta_low, delta_high] = task.limits.shape;
  const auto side = [&](double value, double below, double above) {
    return tolerance * std::max(below, above) > 0
               ? std::optional(
                     Interval{value * (1 - tolerance * below), value * (1 + tolerance * above)})
               : std::nullopt;
  };
  return {{task.problem.p, f, delta},
          {.f = side(f, f_low, f_high),
           .delta = side(delta, delta_low, delta_high),
           .exact = !(task.pulse && has_ranges(task))}};
}

std::optional<TwinsSi> twins_of(const Physical& physical, const ShownResponse& response) {
  return physical
             ? std::optional(TwinsSi{
                   {.input = *physical, .motion = response.response, .forced = response.forced}})
             : std::nullopt;
}

ShownLoaded loaded(const ShownTask& task, double v0, const std::optional<design::Pulse>& pulse,
                   double p, const ShownResponse& response) {
  ShownLoaded now{.what = "hit", .p = p, .response = response};
  if (pulse) {
    now.what = design::name(*pulse);
    now.k = design::peak_load(*pulse);
    now.lambda = design::angular_frequency(*pulse);
  } else {
    now.v0 = v0;
  }
  now.physical = twins_of(task.physical, response);
  return now;
}

void add_worst(ShownCase& now, const ShownTask& task, const BoxedDamper& damper,
               const std::optional<design::PulseWorst>& worst) {
  const bool exactly = !damper.box.f && !damper.box.delta;
  if (worst) {
    const Worst figures{worst->peak, worst->acceleration, {}, worst->stop_time, {}};
    now.nominal = figures;
    if (exactly) {
      now.worst = {figures, {}};
    }
  } else if (exactly && !now.motions.empty()) {
    const ShownLoaded& motion = now.motions.front();
    const Response& response = *motion.response.response;
    const WorstAt here{damper, motion.what};
    WorstInBox box{{.peak = response.peak_amplitude}, {.peak = here}};
    if (!has_ranges(task)) {  // else the motion shown is only the one with the largest peak
      box.acceleration = response.peak_absolute_acceleration;
      box.jump = response.jump;
      box.stop_time = response.stop_time;
      box.of = {here, here, {}, {}, here};
      if (response.stop_position) {
        box.residual = std::abs(*response.stop_position);
        box.of.residual = box.of.stop_time = here;
      }
    }
    now.worst = box;
  }
}

void add_catalogue(ShownAnswer& answer, const std::optional<Catalogue>& catalogue,
                   const ShownTask& task) {
  if (catalogue) {
    answer.input.catalogue = spelled_out(catalogue->file);
    answer.catalogue.emplace();
    for (const design::RatedPart& rated : catalogue->parts) {
      answer.catalogue->push_back(
          {rated, rated.admissible ? std::nullopt : std::optional(judgement(rated, task))});
    }
  }
}

}  // namespace stillpoint::report
