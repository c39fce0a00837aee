// SPDX-License-Identifier: MIT
#include <stillpoint/design/damper_findings.hpp>

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/design/shown_damper.hpp>
#include <stillpoint/design/tolerance.hpp>
#include <stillpoint/records/decimal.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace stillpoint::design {

namespace {

using enum FindingKind;

constexpr double buildable = 0.01;  // a smaller tolerance is too little for a real damper

void add_pulse_notch(std::vector<Finding>& all, const ShownDamper& now) {
  if (!now.pulse || now.point.delta == 0 || now.built != nullptr || !moves(now.response) ||
      !now.admissible) {
    return;
  }
  const SimulationRequest motion = motion_of(now);
  const double peak = now.response.peak_amplitude;
  all.push_back(late_notch(motion.oscillator, motion.excitation,
                           now.ranges.k_low.value_or(peak_load(*now.pulse)), peak,
                           now.problem.residual.value_or(rest_share * peak)));
}

/// The requirements on peak and acceleration under a pulse end with the first swing.
void add_later(std::vector<Finding>& all, const ShownDamper& now) {
  for (const Constraint& bound : now.judged.constraints) {
    const bool peak = bound.variable == "peak";
    if (!bound.satisfied || (!peak && bound.variable != "acceleration")) {
      continue;
    }
    const Figures figures = figures_of(now.response);
    const double whole = peak ? figures.peak : figures.acceleration;
    if (exceeds(whole, bound.limit)) {
      const Dimension dimension = peak ? Dimension::length : Dimension::gravities;
      Finding& later = all.emplace_back(exceeds_later).tell("figure", bound.variable);
      later.add("value", whole, dimension).add("limit", bound.limit, dimension);
    }
  }
}

/// Under a pulse, if the mass feels hardly less than the load.
void add_isolation(std::vector<Finding>& all, const ShownDamper& now) {
  if (!now.pulse) {
    return;
  }
  const double load = peak_load(*now.pulse);
  if (now.felt() > hardly_less * load) {
    all.emplace_back(does_not_isolate)
        .add(transmitted_name, now.felt(), Dimension::gravities)
        .add("largest_load", load, Dimension::gravities);
  }
}

void add_weak_hits(std::vector<Finding>& all, const ShownDamper& now) {
  if (now.pulse || !now.problem.has_caught_hits(now.point.delta)) {
    return;
  }
  // A weaker hit than this is caught at the start: rule 4 of docs/theory.md, section 2.
  const double caught = std::sqrt(2 * now.point.delta);
  Finding& weak = all.emplace_back(catches_weak_hits)
                      .add("caught_impulse", std::min(caught, now.problem.v0), Dimension::velocity);
  if (caught < now.problem.v0) {
    weak.add("least_velocity", caught, Dimension::velocity);
  }
}

void add_recentring(std::vector<Finding>& all, const ShownDamper& now) {
  constexpr double asked = 0.25;  // EN 15129
  const auto ratio = now.judged.practice ? now.judged.practice->energy_ratio : std::nullopt;
  if (ratio && *ratio < asked) {
    all.emplace_back(recentres_weakly).add("energy_ratio", ratio).add("limit", asked);
  }
}

std::vector<Finding> findings_of(const ShownDamper& now, const AskedWith& asked) {
  std::vector<Finding> all;
  if (now.under_pulse != nullptr) {
    const ForcedResponse& forced =
        now.built != nullptr ? now.built->response : now.under_pulse->response;
    if (forced.locks()) {
      all.push_back(lock_of(forced, duration(excitation(now.under_pulse->pulse)).value()));
    }
  }
  add_later(all, now);
  if (asked.weight && now.point.f > 1) {  // without units f has no weight
    all.emplace_back(friction_above_weight).add("f", now.point.f);
  }
  add_weak_hits(all, now);
  add_isolation(all, now);
  add_recentring(all, now);
  add_pulse_notch(all, now);
  return all;
}

/// The motion of the ranges after which the notch as built does what it must not.
void add_motion(Finding& finding, const TriedMotion& motion, const DesignRequest& request) {
  if (!motion.pulse) {
    finding.add("v0", motion.v0, Dimension::velocity);
    if (motion.from_inside) {
      finding.tell("from", "inside");
    }
  } else {
    finding.add("k", peak_load(*motion.pulse), Dimension::gravities);
    if (request.pulse_ranges.lambda_high) {
      finding.add("duration", duration(excitation(*motion.pulse)), Dimension::time);
    }
  }
  if (request.problem.p_high) {
    finding.add("p", motion.p);
  }
}

/// What the notch that will be built spoils, first of all that the motion is another one.
void add_built(std::vector<Finding>& all, const DesignRequest& request, const BuiltNotch& built) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  const ForcedResponse& response = built.response;
  const double rest = std::abs(response.stop_position.value_or(0));
  const bool within =
      problem.residual && response.stop_position && !exceeds(rest, *problem.residual);
  const auto fails = [&](std::string_view what) -> Finding& {
    return all.emplace_back(notch_fails).tell("what", what);
  };
  const auto tell = [&](std::string_view what, double value, std::optional<double> limit,
                        Dimension dimension, TriedMotion WorstMotions::*of) {
    Finding& finding = fails(what).add("value", value, dimension).add("limit", limit, dimension);
    if (built.worst) {
      add_motion(finding, *built.worst.*of, request);
    }
  };
  const auto largest = [&](TriedMotion WorstMotions::*of) -> const ForcedResponse& {
    return built.worst ? (*built.worst.*of).response : response;
  };
  if (response.half_cycles == 0 || built.holds_weakest) {
    fails("held").add(
        "k", built.holds_weakest ? ranges.k_low.value_or(peak_load(*pulse)) : peak_load(*pulse),
        Dimension::gravities);
    return;
  }
  if (built.shape.width && *built.shape.width / 2 >= response.peak_amplitude && !within) {
    fails("inside").add("value", response.stop_position, Dimension::length);
    return;
  }
  const double peak = largest(&WorstMotions::peak).peak_amplitude;
  if (exceeds(peak, problem.beta)) {
    tell("peak", peak, problem.beta, Dimension::length, &WorstMotions::peak);
    return;
  }
  const double allowed = problem.residual.value_or(rest_share * response.peak_amplitude);
  const double farthest = built.worst ? std::abs(built.worst->farthest.rest()) : rest;
  const bool stops =
      response.outcome == Outcome::stopped_at_zero || response.outcome == Outcome::stopped_in_notch;
  if (!response.stop_position) {
    fails("moving");
  } else if (exceeds(farthest, allowed) || !(problem.residual ? within : stops)) {
    tell("rest", farthest, problem.residual, Dimension::length, &WorstMotions::farthest);
  } else if (const double felt = figures_of(largest(&WorstMotions::felt)).acceleration;
             limits.acceleration_max && exceeds(felt, *limits.acceleration_max)) {
    tell("acceleration", felt, limits.acceleration_max, Dimension::gravities, &WorstMotions::felt);
  }
}

/// Of a hit, with a box of delta alone: whether f has next to no room.
bool is_f_on_an_edge(const DesignRequest& request, const DesignPoint& point) {
  Limits alone = request.limits;
  const bool asked = alone.shape.f_low + alone.shape.f_high > 0;
  alone.shape = {1, 1, 0, 0};
  return !asked && !request.pulse &&
         largest_tolerance(request.problem, alone, point.f, point.delta).value_or(0) < buildable;
}

/// Of the search, not of a part.
void add_search(std::vector<Finding>& all, const DesignResult& design) {
  const DesignRequest& request = design.request;
  const DesignPoint& point = design.finding->point;
  const auto too_exact_to_build = [&](double tolerance) {
    Finding& finding =
        all.emplace_back(too_exact).add("tolerance", tolerance < least_tolerance ? 0 : tolerance);
    if (request.search.objective != Objective::robust) {
      finding.tell("asked", "nothing");
    }
  };
  if (wants_no_friction(design)) {
    if (point.tolerance < least_tolerance) {
      too_exact_to_build(point.tolerance);
    }
    Finding& least = all.emplace_back(least_friction_is_best);
    constexpr double kept = 0.9;
    const double less = records::decimal(kept * point.tolerance, 2);
    const auto largest = request.pulse || request.limits.shape != BoxShape{}
                             ? std::nullopt
                             : any_f_up_to(request.problem, request.limits, point.delta, less);
    if (largest && less > 0) {
      least.add("tolerance", less).add("f", *largest);
    }
  } else if (point.tolerance < buildable) {
    too_exact_to_build(point.tolerance);
  } else if (is_f_on_an_edge(request, point)) {
    all.emplace_back(too_exact).add("f", point.f);
  }
  const auto useless = std::ranges::find(all, does_not_isolate, &Finding::kind);
  if (useless != all.end() && request.search.objective != Objective::acceleration &&
      !request.limits.acceleration_max) {
    useless->tell("asked", "nothing");
  }
  if (!request.pulse || request.limits.delta_max) {
    return;
  }
  constexpr double far_beyond = 3;  // times what stops the mass
  const double least = least_delta(pulse_request(request).problem, point.f).value_or(0);
  if (point.delta > far_beyond * least) {
    all.emplace_back(delta_unbounded)
        .add("least_delta", least, Dimension::length)
        .add("proposed", far_beyond * least, Dimension::length);
  }
}

/// Without a damper; a region of a pulse is that of a notch which acts late.
std::vector<Finding> of_region(const RegionVerdict& verdict, bool late) {
  std::vector<Finding> all;
  if (late) {
    all.emplace_back(acts_late);
  }
  if (verdict.mends_cut_short) {
    all.emplace_back(search_cut_short);
  }
  return all;
}

}  // namespace

bool wants_no_friction(const DesignResult& design) {
  constexpr double nothing = 1e-6;  // of the largest f
  return design.finding->search &&
         design.finding->point.f <= nothing * std::max(*design.region.f_upper, design.region.f3);
}

std::optional<double> told_f(const DesignResult& design) {
  if (wants_no_friction(design)) {
    return std::nullopt;
  }
  constexpr int digits_of_double = 17;
  const double f = design.finding->point.f;
  for (int digits = 6; digits < digits_of_double; ++digits) {
    using enum records::Rounding;
    for (const records::Rounding rounding : {nearest, down, up}) {
      const double told = records::decimal(f, digits, rounding);
      if (*design.region.f_lower <= told && told <= *design.region.f_upper) {
        return told;
      }
    }
  }
  return f;
}

std::vector<Finding> findings_of(const DesignResult& design, const std::optional<BuiltNotch>& built,
                                 const AskedWith& asked) {
  if (!design.finding) {
    return of_region(design, false);
  }
  const auto& [problem, limits, search, pulse, ranges] = design.request;
  const Found& found = *design.finding;
  const auto all_of = findings_of(shown_damper(design, built), asked);
  std::vector<Finding> all;
  add_failed(all, found.cross_check);
  if (built) {
    add_built(all, design.request, *built);
  }
  all.insert(all.end(), all_of.begin(), all_of.end());
  if (!asked.a_part) {
    add_search(all, design);
  }
  const bool ranged = problem.v0_low || problem.p_high;
  if (!pulse && !ranged && !found.arrival && !built && found.point.delta > 0 &&
      found.response.zero_passages == 0.0) {
    all.emplace_back(notch_unused);
  }
  if (built && built->changes_nothing) {
    all.emplace_back(notch_changes_nothing);
  }
  if (pulse && (problem.p_high || ranges.lambda_high)) {
    all.emplace_back(ranges_estimated);
  }
  return all;
}

std::vector<Finding> findings_of(const RegionRequest& request, const RegionAnswer& answer,
                                 const AskedWith& asked) {
  if (!answer.response) {
    return of_region(answer, request.pulse && answer.region.feasible);
  }
  return findings_of(shown_damper(request, answer), asked);
}

}  // namespace stillpoint::design
