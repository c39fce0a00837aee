// SPDX-License-Identifier: MIT
#include <stillpoint/design/constraints.hpp>

#include "region/edges.hpp"
#include "way/way.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/design/limit_kinds.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::design {

namespace {

struct Asked {
  const Problem& problem;
  const Edges& edge;
  double f;
};

/// One of the conditions of constraints.hpp.
struct Condition {
  std::string_view name;
  std::string_view variable;
  std::string_view relation;
  double (*limit)(const Asked& asked);
};

constexpr std::array<Condition, 5> conditions{{
    {"dead_zone", "f", "<", [](const Asked& asked) { return asked.edge.f1; }},
    {"start", "delta", "<=", [](const Asked& asked) { return asked.edge.delta2; }},
    {"amplitude", "f", ">=", [](const Asked& asked) { return asked.edge.f2; }},
    {"return", "f", "<=", [](const Asked& asked) { return asked.edge.f3; }},
    // Beyond f3, where the motion does not return, nothing bounds Delta.
    {"stop", "delta", ">",
     [](const Asked& asked) { return delta1(asked.problem, asked.f).value_or(0); }},
}};

/// `return` and `stop` of a later arrival, as in constraints.hpp: of the one where the motion
/// stops, even if the criterion asks for more, or else of the one that it misses.
void compare_hits(std::array<Constraint, 5>& list, const Problem& problem, double f, double delta) {
  const auto [at, stops] = deciding_arrival(strongest_hit(problem), f, delta);
  const int n = stops ? at : deciding_arrival(problem, f, delta).n;
  if (n > 1) {
    const auto [reach, pass] = way_speeds(Way(problem, {}, n), f, delta);
    list[3] = Constraint::compared("return", "v0", ">=", problem.v0, reach);
    list[4] = Constraint::compared("stop", "v0", "<", problem.v0, pass);
  }
}

/// The same task with room for any peak and any dead zone of this f.
Problem without_stroke(Problem problem, double f) {
  if (problem.residual) {
    problem.residual = residual_of(problem);
  }
  problem.beta =
      std::max({problem.beta, 2 * problem.v0 / problem.p, 2 * f / problem.p / problem.p});
  return problem;
}

/// The way that the damper takes, whatever the stroke is, or the one that it would need.
Way compared_way(const Problem& problem, double f, double delta) {
  if (const auto taken = way_of(problem, {}, f, delta)) {
    return *taken;
  }
  if (const auto rests = way_of(without_stroke(problem, f), {}, f, delta)) {
    return way_with(problem, {}, rests->n, f);
  }
  return {problem, {}, deciding_arrival(strongest_hit(problem), f, delta).n};
}

void compare_way(std::array<Constraint, 5>& list, const Problem& problem, double f, double delta) {
  const Way way = compared_way(problem, f, delta);
  if (way.is_papers()) {
    return;
  }
  const auto [reach, pass] = way_speeds(way, f, delta);
  // With all friction below the dead zone's limit it rests within the residual.
  const bool any_f = way.n == 0 && way.f_cap >= std::nextafter(list[0].limit, 0.0);
  list[3] = way.at_peak  ? Constraint::compared("residual", "f", ">=", f, way.f2)
            : any_f      ? Constraint::compared("residual", "f", ">=", f, 0)
            : way.n == 0 ? Constraint::compared("residual", "f", "<=", f, way.f_cap)
            : way.returns_by_delta()
                ? Constraint::compared("return", "delta", ">=", delta, reach)
                // Of every hit up to v0 the weakest that moves is the one that the notch just lets
                // go.
                : Constraint::compared(
                      "return", "v0",
                      ">=", way.v_low > 0 ? way.v_low * problem.v0 : std::sqrt(2 * delta), reach);
  if (const double most = largest_f(problem); !list[3].satisfied && f > most) {
    list[3] = Constraint::compared(problem.residual ? "residual" : "return", "f", "<=", f,
                                   most);  // no delta and no hit helps
  }
  list[4] = Constraint::compared("stop", "v0", "<", problem.v0, pass);
}

}  // namespace

Constraint Constraint::compared(std::string_view name, std::string_view variable,
                                std::string_view relation, double value, double limit) {
  const bool below = relation.front() == '<';
  const double slack = below ? limit - value : value - limit;
  const bool strict = relation.size() == 1;
  return {name, variable, relation, value, limit, slack, strict ? slack > 0 : slack >= 0};
}

Dimension Constraint::dimension() const {
  return variable == "delta" || variable == "peak" || variable == "residual" ? Dimension::length
         : variable == "v0" || variable == "jump"                            ? Dimension::velocity
         : variable == "acceleration"                                        ? Dimension::gravities
                                                                             : Dimension::none;
}

std::array<Constraint, 5> constraints(const Problem& problem, double f, double delta) {
  require_valid(problem);
  const Edges edge = edges(problem, {});
  require_within("f", f, 0, largest_square);
  require_within("delta", delta, 0, largest_square);
  const Asked asked{problem, edge, f};
  std::array<Constraint, 5> list;
  std::ranges::transform(conditions, list.begin(), [&](const Condition& condition) {
    return Constraint::compared(condition.name, condition.variable, condition.relation,
                                condition.variable == "f" ? f : delta, condition.limit(asked));
  });
  if (!is_plain(problem, {})) {
    compare_way(list, problem, f, delta);
  } else if (problem.arrivals > 1) {
    compare_hits(list, problem, f, delta);
  }
  if (problem.criterion == Criterion::published && !list[4].satisfied) {
    Problem exact = problem;
    exact.criterion = Criterion::exact;
    const auto of_the_motion = constraints(exact, f, delta);
    list[4].by_criterion_alone = of_the_motion[3].satisfied && of_the_motion[4].satisfied;
  }
  return list;
}

std::vector<Constraint> constraints(const Problem& problem, const Limits& limits, double f,
                                    double delta) {
  const auto of_the_motion = constraints(problem, f, delta);
  std::vector<Constraint> list(of_the_motion.begin(), of_the_motion.end());
  for (const auto& [kind, limit, edge] : limit_edges(problem, limits)) {
    const bool of_f = kind->bounds_f();
    list.push_back(
        Constraint::compared(kind->constraint, of_f ? "f" : "delta", "<=", of_f ? f : delta, edge));
  }
  return list;
}

const Constraint* governing(std::span<const Constraint> constraints) {
  const Constraint* least = nullptr;
  for (const Constraint& now : constraints) {
    const bool bounds = now.known && now.limit > 0 && std::isfinite(now.limit);
    if (bounds && (least == nullptr || part_left(now) < part_left(*least))) {
      least = &now;
    }
  }
  return least;
}

}  // namespace stillpoint::design
