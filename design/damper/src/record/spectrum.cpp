// SPDX-License-Identifier: MIT
#include <stillpoint/design/spectrum.hpp>

#include "record/suite.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <string_view>
#include <utility>

namespace stillpoint::design {

namespace {

/// One with very many half-cycles is followed only to its peak, which comes at most half a period
/// after the load: friction only takes energy from then on.
Figures figures(const Oscillator& oscillator, const CaseMotion& of, const Surface& surface) {
  try {
    const ForcedResponse motion = forced_response(
        oscillator, of.start, of.load, {.half_cycle_limit = most_suite_half_cycles}, surface);
    Figures all = figures_of(motion);
    if (all.residual && !rests_in_time(motion.half_cycles.value())) {
      all.residual.reset();
    }
    return all;
  } catch (const TooManyHalfCycles&) {
    const double t_end = duration(of.load).value() + 2 * std::numbers::pi / oscillator.p;
    const Figures all =
        figures_of(forced_response(oscillator, of.start, of.load, {.t_end = t_end}, surface));
    return {all.peak, all.acceleration, all.jump};
  }
}

Oscillator with_p(const SpectrumRequest& request, double p) {
  Oscillator oscillator = request.damper;
  oscillator.p = p;
  return oscillator;
}

Oscillator without_notch(Oscillator oscillator) {
  oscillator.delta = 0;
  oscillator.hold.reset();
  return oscillator;
}

void require_valid(const SpectrumRequest& request) {
  design::require_valid(request.load);
  if (request.p.empty()) {
    throw InputError::missing("p", "give at least one");
  }
  for (const double p : request.p) {
    require_valid(with_p(request, p));
    if (const auto& pulse = request.load.pulse) {
      const double most = most_suite_half_cycles * angular_frequency(*pulse);
      if (p > most) {
        throw InputError("p", p,
                         fmt::format("must be at most {:.6g}: under so long a pulse the mass "
                                     "swings more than 10 000 times",
                                     most));
      }
    }
    require_valid(with_p(request, p), Surface{request.notch_width, {}});
  }
}

Figures combined(const std::vector<std::vector<SpectrumPoint>>& motions, std::size_t place,
                 Figures SpectrumPoint::*which, Combine combine) {
  Figures all{0, 0, 0, 0};
  const auto count = static_cast<double>(motions.size());
  const auto add = [&](double& figure, double value) {
    figure = combine == Combine::max ? std::max(figure, value) : figure + value / count;
  };
  for (const std::vector<SpectrumPoint>& motion : motions) {
    const Figures& one = motion[place].*which;
    add(all.peak, one.peak);
    add(all.acceleration, one.acceleration);
    add(all.jump, one.jump);
    if (one.residual && all.residual) {
      add(*all.residual, *one.residual);
    } else {
      all.residual.reset();
    }
    if (one.locked) {
      all.locked = std::min(*one.locked, all.locked.value_or(HUGE_VAL));
      all.largest_load_while_locked =
          std::max(*one.largest_load_while_locked, all.largest_load_while_locked.value_or(0));
    }
  }
  return all;
}

/// Where the notch holds the mass while the load goes on. One that lets go, or has a width, is to
/// hold it at the end, unless that is what the structure feels most.
void add_lock(std::vector<Finding>& all, const Spectrum& spectrum) {
  std::size_t count = 0;
  double most = 0;
  bool worst = true;
  for (const SpectrumPoint& point : spectrum.combined) {
    const auto& held = point.with_notch.largest_load_while_locked;
    count += point.with_notch.locked ? 1U : 0U;
    most = std::max(most, held.value_or(0));
    worst = worst && held == point.with_notch.acceleration;
  }
  if (count == 0) {
    return;
  }
  Finding& lock = all.emplace_back(FindingKind::locks)
                      .add("largest_load_while_locked", most, records::Dimension::gravities)
                      .count("of_records", spectrum.motions.size())
                      .count("periods", count)
                      .count("of_periods", spectrum.combined.size());
  const SpectrumRequest& task = spectrum.request;
  if ((task.damper.hold || task.notch_width) && !worst) {
    lock.severity = Severity::info;
  }
}

std::vector<Finding> findings_of(const Spectrum& spectrum) {
  std::vector<Finding> all;
  add_lock(all, spectrum);
  const SpectrumRequest& task = spectrum.request;
  if (task.load.v0 && !task.notch_width && holds_at_start(task.damper.delta, *task.load.v0)) {
    all.emplace_back(FindingKind::catches_hit)
        .add("caught_impulse", task.load.v0, records::Dimension::velocity)
        .add("least_velocity", std::sqrt(2 * task.damper.delta), records::Dimension::velocity);
  }
  const auto jump = [](const SpectrumPoint& point) { return point.with_notch.jump; };
  const auto most = std::ranges::max_element(spectrum.combined, {}, jump);
  if (jump(*most) > 0) {
    all.emplace_back(FindingKind::jolts)
        .add("jump", jump(*most), records::Dimension::velocity)
        .add("p", most->p);
  }
  return all;
}

}  // namespace

std::size_t Spectrum::resting(Figures SpectrumPoint::*member) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      combined,
      [member](const SpectrumPoint& point) { return (point.*member).residual.has_value(); }));
}

Spectrum spectrum(const SpectrumRequest& request, const std::function<bool(double)>& go_on) {
  require_valid(request);
  Spectrum result{request, {}, {}, {}};
  const Combine combine =
      request.load.combine.value_or(default_combine(request.load.records.size()));
  result.request.load.combine = combine;
  const std::vector<CaseMotion> motions = motions_of(request.load);
  const std::size_t points = request.p.size();
  result.motions.assign(motions.size(), std::vector<SpectrumPoint>(points));
  const std::size_t entries = motions.size() * points;
  std::mutex one_at_a_time;
  std::size_t done = 0;
  const auto goes_on = [&] {
    if (!go_on) {
      return true;
    }
    const std::lock_guard lock(one_at_a_time);
    return go_on(static_cast<double>(done++) / static_cast<double>(entries));
  };
  for_each_entry(static_cast<std::ptrdiff_t>(entries), request.threads, goes_on,
                 [&](std::ptrdiff_t entry) {
                   const auto index = static_cast<std::size_t>(entry);
                   const CaseMotion& motion = motions[index / points];
                   const Oscillator oscillator = with_p(request, request.p[index % points]);
                   SpectrumPoint& point = result.motions[index / points][index % points];
                   point.with_notch = figures(oscillator, motion, Surface{request.notch_width, {}});
                   point.without = figures(without_notch(oscillator), motion, {});
                   point.p = oscillator.p;
                 });
  result.combined.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    SpectrumPoint& point = result.combined[i];
    point.p = request.p[i];
    for (const auto member : {&SpectrumPoint::with_notch, &SpectrumPoint::without}) {
      point.*member = combined(result.motions, i, member, combine);
    }
  }
  result.findings = findings_of(result);
  return result;
}

std::string summary(const Spectrum& spectrum) {
  const std::vector<SpectrumPoint>& points = spectrum.combined;
  if (spectrum.request.damper.delta == 0) {
    return "Delta is 0, so there is no notch to compare with.";
  }
  std::string text;
  const auto add = [&](std::string_view before, std::string_view name, const auto& value) {
    const auto count_less = [&](Figures SpectrumPoint::*first, Figures SpectrumPoint::*second) {
      return std::ranges::count_if(points, [&](const SpectrumPoint& point) {
        return value(point.*first) < value(point.*second);
      });
    };
    const auto raised = count_less(&SpectrumPoint::without, &SpectrumPoint::with_notch);
    const auto lowered = count_less(&SpectrumPoint::with_notch, &SpectrumPoint::without);
    const bool everywhere = static_cast<std::size_t>(lowered) == points.size();
    text += fmt::format("{} the {} at {}{}", before, name,
                        everywhere     ? "every period"
                        : lowered == 0 ? "no period"
                                       : fmt::format("{} of {} periods", lowered, points.size()),
                        raised > 0 ? fmt::format(" (raises it at {})", raised) : "");
  };
  add(": the notch lowers", "residual",
      [](const Figures& one) { return one.residual.value_or(HUGE_VAL); });
  add(",",
      spectrum.request.notch_width
          ? "transmitted acceleration"
          : "transmitted acceleration between the velocity jumps at the notch",
      [](const Figures& one) { return one.acceleration; });
  add(", and", "peak", [](const Figures& one) { return one.peak; });
  return suite_words(spectrum.request.load) + text + ".";
}

}  // namespace stillpoint::design
