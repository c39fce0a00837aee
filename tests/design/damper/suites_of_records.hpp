// SPDX-License-Identifier: MIT
#pragma once

// Records to design for.

#include "damper.hpp"

#include <stillpoint/records/record_file.hpp>

namespace stillpoint::design_test {

// A period of 2.8 s with p = 1: lengths in g/omega^2, 1.947 m.
inline constexpr double omega = 2 * std::numbers::pi / 2.8;
inline constexpr double metre = omega * omega / 9.80665;

inline design::SuiteRecord recorded(const std::string& file, double scale = 1) {
  records::RecordOptions options;
  options.clock = {"s", 1 / omega, 1};
  const std::string path = std::string(STILLPOINT_DATA_DIR) + "/records/" + file;
  return {file, records::read_record(path, options).record, scale};
}

inline design::RecordDesignRequest two_records() {
  return {.cases = {{.records = {recorded("near_fault_pulse.txt"), recorded("strong_motion.AT2")},
                     .limits = {.peak = 0.25 * metre, .residual = 0.005 * metre}}},
          .scan_points = 2500};
}

/// Seven radians of shaking, so that a whole search takes a quarter of a second.
inline design::RecordDesignRequest short_records() {
  Record one{{}, 0.25, {}};
  Record other = one;
  for (int i = 0; i < 30; ++i) {
    one.values.push_back(0.3 * std::sin(0.7 * i) + 0.2 * std::sin(0.23 * i));
    other.values.push_back(0.4 * std::sin(0.11 * i * i));
  }
  return {.cases = {{.records = {{"one", one, 1}, {"other", other, -0.8}},
                     .limits = {.peak = 0.4, .residual = 0.02}}},
          .scan_points = 2500};
}

/// A hit that must stop at x = 0 by its first arrival.
inline design::LoadCase hit_case(double v0, double beta) {
  return {.name = "hit", .v0 = v0, .limits = {.peak = beta, .residual = 0, .passages = 0}};
}

/// One of V0 = 1.
inline design::RecordDesignRequest under_hit(const Interval& zeta, double beta) {
  design::RecordDesignRequest request{
      .cases = {hit_case(1, beta)}, .objective = design::SuiteObjective::robust, .zeta = zeta};
  return request;
}

/// Of that damper alone.
inline design::RecordDesignRequest judge(design::RecordDesignRequest request, double f,
                                         double delta) {
  request.f = Interval{f, f};
  request.delta = Interval{delta, delta};
  request.judges = true;
  return request;
}

/// The same without a tolerance.
inline design::RecordDesignRequest exactly(design::RecordDesignRequest request) {
  request.tolerance = {{}, {}, {}, {}};
  return request;
}

inline bool is_admissible(const design::RecordDesignRequest& request, double f, double delta) {
  const design::RecordDesign judged = design::design(exactly(judge(request, f, delta)));
  return judged.finding && judged.finding->admissible;
}

/// The records in a case with the limit of the stroke, and again in one with that of the residual.
inline design::RecordDesignRequest split(const design::RecordDesignRequest& one) {
  design::RecordDesignRequest two = one;
  two.cases.push_back(two.cases.front());
  two.cases[0].name = "stroke";
  two.cases[0].limits.residual.reset();
  two.cases[1].name = "residual";
  two.cases[1].limits.peak.reset();
  return two;
}

/// W = 0.4 at 0, -0.2 at 1, 0 at 2.
inline design::RecordDesignRequest three_samples() {
  return {.cases = {{.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}}}},
          .scan_points = 100};
}

}  // namespace stillpoint::design_test
