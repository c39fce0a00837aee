// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/field.hpp>
#include <stillpoint/design/problem.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// One of the five conditions, all of them edges of the region in f or Delta.
///
/// | name      | condition        | value | limit  | the motion ...                              |
/// |-----------|------------------|-------|--------|---------------------------------------------|
/// | dead_zone | f < f1           | f     | f1     | has a dead zone narrower than beta          |
/// | start     | Delta <= Delta2  | Delta | Delta2 | starts                                      |
/// | amplitude | f >= f2          | f     | f2     | stays within beta                           |
/// | return    | f <= f3          | f     | f3     | comes back to x = 0                         |
/// | stop      | Delta > Delta1   | Delta | Delta1 | stops there                                 |
///
/// slack is the distance from value to limit, positive inside; the strict ones need slack > 0. Each
/// is compared alone: where `return` is violated there is no arrival that `stop` could judge.
///
/// For a damper whose motion stops at a later arrival, `return` and `stop` compare V0 with the
/// least one that reaches that arrival and the least that passes it, (47) of docs/theory.md. With
/// an f beyond every damper of the task, `return`, or `residual` with one, compares f with the
/// largest that one has.
struct Constraint {
  std::string_view name;
  std::string_view variable;  ///< what `value` is: f or delta; v0 for a later arrival
  std::string_view relation;
  double value{0};
  double limit{0};
  double slack{0};
  bool satisfied{false};
  /// Of a violated `stop`: the motion stops, only the published criterion asks for more.
  bool by_criterion_alone{false};
  bool known{true};  ///< not where a motion never rests: then value and slack have no meaning
  struct Motion {
    std::string file;
    double scale{1};
  };
  std::string in_case{};           ///< its name; empty of a single one
  std::optional<Motion> motion{};  ///< without a design, that of the record with the largest value

  /// With the slack of a relation <, <=, > or >=.
  [[nodiscard]] static Constraint compared(std::string_view name, std::string_view variable,
                                           std::string_view relation, double value, double limit);
  /// Of the variable.
  [[nodiscard]] Dimension dimension() const;
};

/// The part of its limit that it leaves; where that is 0, and broken, the slack.
[[nodiscard]] inline double part_left(const Constraint& now) {
  return now.limit > 0 ? now.slack / now.limit : now.slack;
}
/// The one that leaves the least part of a limit above 0; none if there is none.
[[nodiscard]] const Constraint* governing(std::span<const Constraint> constraints);

/// In the order of the table. Throws InputError for a wrong problem and f or delta not in [0,
/// 1e300].
[[nodiscard]] std::array<Constraint, 5> constraints(const Problem& problem, double f, double delta);

/// With one more row for each limit that is given (limit_kinds.hpp).
[[nodiscard]] std::vector<Constraint> constraints(const Problem& problem, const Limits& limits,
                                                  double f, double delta);

}  // namespace stillpoint::design
