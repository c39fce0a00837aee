// SPDX-License-Identifier: MIT
#include <stillpoint/design/record_design.hpp>

#include "check/runge_kutta.hpp"
#include "record/suite.hpp"
#include "record/suite_digits.hpp"
#include "record/suite_search.hpp"
#include "record/suite_watch.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/seconds.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <variant>

namespace stillpoint::design {

namespace {

/// A limit alone that was relaxed is this much above the least that was found, so that a search
/// with it, which is no more accurate than that, finds a damper as well.
constexpr double relaxed_by = 1e-3;

/// Besides the corners of the tolerance box, or its ends if only f or Delta can be off.
constexpr int random_samples = 60;
constexpr std::uint64_t sampling_seed = 20'081;

void require_range(const char* field, const Interval& range, double low, double high) {
  require_within(field, range.low, low, high);
  require_within(field, range.high, low, high);
  if (range.high < range.low) {
    throw InputError(field, fmt::format("{}:{}", range.low, range.high),
                     "must have the lower end first");
  }
}

void require_limit(const char* field, const std::optional<double>& limit, double least) {
  if (limit) {
    require_within(field, *limit, least, largest_speed);
  }
}

void require_valid(const RecordDesignRequest& request) {
  design::require_valid(request.records);
  require_range("p", request.p, smallest_speed, largest_speed);
  require_limit("beta", request.limits.peak, smallest_speed);
  require_limit("acceleration-max", request.limits.acceleration, smallest_speed);
  require_limit("residual", request.limits.residual, 0);
  require_within("tolerance", request.tolerance, 0, 1 - 1e-9);
  require_within("scan_points", static_cast<double>(request.scan_points), 1, 1e8);
}

/// No farther than what can be manufactured.
void keep_below(std::optional<Interval>& range, const std::optional<double>& most,
                const char* field) {
  if (!most) {
    return;
  }
  require_within(field, *most, 0, largest_speed);
  range = range.value_or(Interval{0, *most});
  if (range->low > *most) {
    throw InputError(field, *most,
                     fmt::format("must be at least {}, where the search begins", range->low));
  }
  range->high = std::min(range->high, *most);
}

/// Fills in the ranges and the combination that the request leaves open.
RecordDesignRequest completed(RecordDesignRequest request) {
  request.combine = request.combine.value_or(default_combine(request.records.size()));
  keep_below(request.f, request.f_max, "f-max");
  keep_below(request.delta, request.delta_max, "delta-max");
  request.f = request.f.value_or(Interval{0, peak_load(request.records)});
  require_range("f", *request.f, 0, largest_speed);
  if (!request.delta) {
    double peak = request.limits.peak.value_or(0);
    for (const SuiteRecord& record : request.records) {
      if (!request.limits.peak) {
        const Excitation load = record.record;
        const ForcedResponse free =
            forced_response({request.p.low, 0, 0}, {}, load, {.t_end = duration(load)});
        peak = std::max(peak, std::abs(record.scale) * free.peak_amplitude);
      }
    }
    const double speed = request.p.high * peak;
    request.delta = Interval{0, speed * speed / 2 + peak_load(request.records) * peak};
  }
  require_range("delta", *request.delta, 0, largest_square);
  for (const double p : {request.p.low, request.p.high}) {
    for (const double f : {request.f->low, request.f->high}) {
      for (const double delta : {request.delta->low, request.delta->high}) {
        require_valid(Oscillator{p, f, delta, request.hold});
        require_valid(Oscillator{p, f, delta, request.hold}, Surface{request.notch_width, {}});
      }
    }
  }
  return request;
}

/// In [-1, 1). The library's distributions differ between implementations.
double between_minus_one_and_one(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1;
}

std::optional<MuchWorse> nearest_much_worse(const Suite& suite, const RecordDesignRequest& request,
                                            const SuitePoint& chosen) {
  constexpr int halvings = 17;  // of a tenth: to the least margin that a design may have
  const auto& [p, f, delta] = chosen.damper;
  for (int k = halvings; k >= 0; --k) {
    const double change = std::ldexp(request.tolerance, -k);
    for (const int of_f : {-1, 0, 1}) {
      for (const int of_delta : {-1, 0, 1}) {
        const SuiteFigures there =
            suite.figures({p, f * (1 + of_f * change), delta * (1 + of_delta * change)});
        if (is_much_worse(there, chosen.figures, request)) {
          return MuchWorse{change, there};
        }
      }
    }
  }
  return std::nullopt;
}

/// Of what can be off: a zero stays zero.
std::vector<double> both_ends(double value) {
  return value > 0 ? std::vector<double>{-1, 1} : std::vector<double>{0};
}

Sensitivity sensitivity(const Suite& suite, const RecordDesignRequest& request,
                        const SuitePoint& chosen) {
  const SuiteDamper& damper = chosen.damper;
  std::mt19937_64 random(sampling_seed);
  std::vector<std::pair<double, double>> places;
  for (const double f : both_ends(damper.f)) {
    for (const double delta : both_ends(damper.delta)) {
      places.emplace_back(f, delta);
    }
  }
  for (int i = 0; i < random_samples; ++i) {
    const double f = between_minus_one_and_one(random);
    places.emplace_back(f, between_minus_one_and_one(random));
  }
  Sensitivity result;
  result.tolerance = request.tolerance;
  result.worst = chosen.figures;
  result.much_worse = nearest_much_worse(suite, request, chosen);
  for (const auto& [f, delta] : places) {
    const SuiteFigures there = suite.figures({damper.p, damper.f * (1 + request.tolerance * f),
                                              damper.delta * (1 + request.tolerance * delta)});
    ++result.samples;
    result.admissible += admissible(there, request.limits) ? 1 : 0;
    SuiteFigures& worst = result.worst;
    worst.settled = worst.settled && there.settled;
    if (there.settled) {
      worst.peak = std::max(worst.peak, there.peak);
      worst.acceleration = std::max(worst.acceleration, there.acceleration);
      worst.residual = std::max(worst.residual, there.residual);
      worst.margin = std::min(worst.margin, there.margin);
    }
  }
  return result;
}

double relative(double error, double size) {
  return size > 0 ? std::abs(error) / size : std::abs(error);
}

SuiteCheck check(const Suite& suite, const SuiteDamper& damper,
                 const std::vector<ForcedResponse>& responses) {
  const double begun = seconds_now();
  SuiteCheck check;
  check.passed = true;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const SuiteFigures kernel = suite_figures(responses[i]);
    const SuiteFigures other = integrate_record_motion(suite.oscillator(damper), suite.surface(),
                                                       std::get<Record>(suite.loads()[i]));
    const double error =
        std::max({relative(other.peak - kernel.peak, kernel.peak),
                  relative(other.acceleration - kernel.acceleration, kernel.acceleration),
                  relative(other.residual - kernel.residual, kernel.peak)});
    check.records.push_back({other.peak, other.acceleration, other.residual, error});
    check.relative_error = std::max(check.relative_error, error);
    check.passed = check.passed && other.settled && error <= check.tolerance;
  }
  check.wall_time_s = seconds_now() - begun;
  return check;
}

/// What each limit would have to be, with the others unchanged.
std::vector<SuiteShortfall> shortfalls(const Suite& suite, const SuiteBox& box,
                                       const SuiteScan& scan, const RecordDesignRequest& request,
                                       const SuiteFigures& nearest, std::int64_t& evaluations,
                                       SuiteWatch& watch) {
  watch.expect(usual_evaluations(box) *
               std::ranges::count_if(suite_figure_kinds, [&](const auto& kind) {
                 return (request.limits.*kind.limit).has_value();
               }));
  std::vector<SuiteShortfall> list;
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    SuiteLimits limits = request.limits;
    const std::optional<double> limit = std::exchange(limits.*kind.limit, std::nullopt);
    if (!limit) {
      continue;
    }
    const SuiteOptimum least =
        optimum(suite, box, scan, kind.objective, limits, request.threads, watch);
    evaluations += least.evaluations;
    SuiteShortfall shortfall{kind.objective, *limit, nearest.*kind.value, {}};
    if (!watch.stopped() && admissible(least.point.figures, limits)) {
      shortfall.relaxed = least.point.figures.*kind.value * (1 + relaxed_by);
    }
    list.push_back(shortfall);
  }
  return list;
}

/// With the figures of a scan, if there are any.
RecordDesign design(const RecordDesignRequest& request, const std::vector<SuiteFigures>* scanned,
                    const RecordWatch& go_on) {
  require_valid(request);
  const double begun = seconds_now();
  RecordDesign result{completed(request), {}, {}, {}, {}};
  const RecordDesignRequest& task = result.request;
  const Suite suite(task);
  const SuiteBox box(task);
  SuiteWatch watch(task, go_on);
  const auto [side, all] = grid_size(box, task.scan_points);
  watch.expect((scanned != nullptr ? 0 : all) + usual_evaluations(box));
  SuiteScan scan{side, scanned != nullptr
                           ? *scanned
                           : grid_figures(suite, box, side, 0, all, task.threads, watch)};
  const auto evaluated = std::ssize(scan.figures);
  if (scanned != nullptr && evaluated != all) {
    throw InputError("scanned", fmt::format("{} dampers", evaluated),
                     fmt::format("must be {}, the number of the scan", all));
  }
  SuiteFigures unknown;
  unknown.settled = false;
  scan.figures.resize(static_cast<std::size_t>(all), unknown);
  SuiteOptimum found = optimum(suite, box, scan, task.objective, task.limits, task.threads, watch);
  result.search = {found.algorithm,
                   found.status,
                   found.evaluations,
                   0,
                   evaluated,
                   std::ranges::count_if(scan.figures,
                                         [&](const SuiteFigures& figures) {
                                           return admissible(figures, task.limits);
                                         }),
                   false};
  result.nearest = found.point;
  const bool feasible = admissible(found.point.figures, task.limits);
  if (!feasible) {
    result.shortfalls =
        shortfalls(suite, box, scan, task, found.point.figures, result.search.evaluations, watch);
  }
  result.search.interrupted = watch.stopped();
  result.search.wall_time_s = seconds_now() - begun;
  if (feasible) {
    const SuitePoint point = with_few_digits(suite, task, found.point);
    result.nearest = point;
    RecordFinding finding{point, suite.responses(point.damper), {}, {}};
    finding.sensitivity = sensitivity(suite, task, point);
    finding.check = check(suite, point.damper, finding.responses);
    result.finding = std::move(finding);
  }
  return result;
}

}  // namespace

RecordDesign design(const RecordDesignRequest& request, const RecordWatch& go_on) {
  return design(request, nullptr, go_on);
}

RecordDesign design(const RecordDesignRequest& request, const std::vector<SuiteFigures>& scanned,
                    const RecordWatch& go_on) {
  return design(request, &scanned, go_on);
}

std::int64_t scan_size(const RecordDesignRequest& request) {
  require_valid(request);
  return grid_size(SuiteBox(completed(request)), request.scan_points).all;
}

std::vector<SuiteFigures> scan_part(const RecordDesignRequest& request, std::int64_t first,
                                    std::int64_t count, const RecordWatch& go_on) {
  require_valid(request);
  const RecordDesignRequest task = completed(request);
  const SuiteBox box(task);
  const GridSize size = grid_size(box, task.scan_points);
  require_within("first", static_cast<double>(first), 0, static_cast<double>(size.all));
  require_within("count", static_cast<double>(count), 0, static_cast<double>(size.all - first));
  SuiteWatch watch(task, go_on);
  watch.expect(count);
  return grid_figures(Suite(task), box, size.side, first, count, task.threads, watch);
}

SuiteFigures figures_of(const RecordDesignRequest& request, const SuiteDamper& damper) {
  return Suite(request).figures(damper);
}

bool is_much_worse(const SuiteFigures& figures, const SuiteFigures& chosen,
                   const RecordDesignRequest& request) {
  constexpr double much = 1.5;
  return !figures.settled ||
         std::ranges::any_of(suite_figure_kinds, [&](const SuiteFigureKind& kind) {
           const bool minimised = kind.objective == request.objective;
           const std::optional<double> had =
               minimised ? chosen.*kind.value : request.limits.*kind.limit;
           const double nothing =
               kind.objective == SuiteObjective::residual ? chosen.peak / 100 : 0;
           return had && figures.*kind.value > std::max(much * *had, nothing);
         });
}

SuiteMap suite_map(const RecordDesignRequest& request, double p, int side) {
  require_valid(request);
  require_within("side", side, 1, 10'000);
  const RecordDesignRequest task = completed(request);
  const Suite suite(task);
  SuiteMap map;
  const auto middle = [side](const Interval& range, int i) {
    return range.low + (range.high - range.low) * (i + 0.5) / side;
  };
  for (int i = 0; i < side; ++i) {
    map.f.push_back(middle(*task.f, i));
    map.delta.push_back(middle(*task.delta, i));
  }
  const auto cells = static_cast<std::size_t>(side);
  std::vector<SuiteDamper> dampers;
  dampers.reserve(cells * cells);
  for (const double f : map.f) {
    for (const double delta : map.delta) {
      dampers.push_back({p, f, delta});
    }
  }
  map.figures = suite.figures(dampers, task.threads);
  return map;
}

std::string summary(const RecordDesign& result) {
  const auto& [damper, figures] = result.finding ? result.finding->point : result.nearest;
  const std::string point =
      fmt::format("p = {:.6g}, f = {:.6g}, delta = {:.6g}", damper.p, damper.f, damper.delta);
  const std::string does =
      figures.settled
          ? fmt::format("transmits {:.4g} g, moves up to |x| = {:.4g} and rests within {:.4g}",
                        figures.acceleration, figures.peak, figures.residual)
          : "does not come to rest";
  return result.finding ? fmt::format("{} {}{}", point, does,
                                      result.finding->check.passed ? "" : "; the check failed")
                        : fmt::format("no damper: the nearest, {}, {}", point, does);
}

}  // namespace stillpoint::design
