// SPDX-License-Identifier: MIT
#include "suites.hpp"

#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/record_suite.hpp>

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

namespace stillpoint::bench {

namespace {

using design::RecordDesignRequest;
using design::SuiteObjective;
using design::SuiteRecord;

SuiteRecord read(const std::string& path) {
  records::RecordOptions options;
  options.clock = {"s", 1 / omega, 1};
  return {path, records::read_record(path, options).record, 1};
}

SuiteRecord times(double scale, SuiteRecord record) {
  record.scale = scale;
  return record;
}

/// That many half-waves of a sine of 0.4 g, sampled, and a second of rest.
SuiteRecord sine(double seconds, int half_waves) {
  constexpr int samples = 200;
  Record record;
  record.step = seconds * omega / samples;
  for (int i = 0; i <= samples; ++i) {
    record.values.push_back(0.4 * std::sin(std::numbers::pi * half_waves * i / samples));
  }
  record.values.back() = 0;
  record.values.push_back(0);
  return {fmt::format("{} s", seconds), std::move(record), 1};
}

/// What is asked for; the least acceleration, or within a limit on it the least stroke.
struct Task {
  double stroke_mm{0};
  double residual_mm{0};
  std::optional<double> hold{};
  std::optional<double> acceleration{};
  Interval periods_s{2.8, 2.8};
  std::optional<double> width_mm{};
};

/// A notch without a width may have any jump.
constexpr double any_jump = 1e3;

NamedSuite suite(const std::string& name, std::vector<SuiteRecord> records, const Task& task) {
  RecordDesignRequest request;
  request.records = std::move(records);
  request.p = {2.8 / task.periods_s.high, 2.8 / task.periods_s.low};
  request.limits = {
      task.stroke_mm * 1e-3 * metre, task.acceleration, task.residual_mm * 1e-3 * metre, {}, {}};
  request.hold = task.hold;
  if (task.width_mm) {
    const double width = *task.width_mm * 1e-3 * metre;
    request.width = Interval{width, width};
  } else {
    request.limits.jump = any_jump;
  }
  if (task.acceleration) {
    request.objective = SuiteObjective::amplitude;
  }
  return {fmt::format("{}; stroke {} mm, residual {} mm", name, task.stroke_mm, task.residual_mm),
          std::move(request)};
}

std::vector<SuiteRecord> read_suite(const std::string& path) {
  records::RecordOptions options;
  options.clock = {"s", 1 / omega, 1};
  records::RecordScale scale;
  scale.spectrum_p = 1;
  const bool is_list = path.ends_with(".csv");
  return records::read_suite({is_list ? std::vector<std::string>{} : std::vector{path},
                              is_list ? std::optional(path) : std::nullopt},
                             scale, options);
}

}  // namespace

std::string notch_words(const RecordDesignRequest& request) {
  return request.width   ? fmt::format("{:.4g} mm wide", 1e3 * request.width->low / metre)
         : !request.hold ? std::string("the paper's")
                         : fmt::format("holds {:.4g} g", *request.hold);
}

std::vector<NamedSuite> suites(const std::string& folder, const std::optional<std::string>& more) {
  const SuiteRecord pulse = read(folder + "/near_fault_pulse.txt");
  const SuiteRecord strong = read(folder + "/strong_motion.AT2");
  const std::vector both{pulse, strong};
  const std::vector seven{times(0.7, pulse),  pulse,  times(1.3, pulse),
                          times(0.8, strong), strong, times(1.2, strong),
                          times(-1, strong)};
  std::vector<NamedSuite> all{
      suite("both", both, {300, 5}),
      suite("both", both, {400, 5, 0.1}),
      suite("both", both, {400, 30, {}, {}, {2.8, 2.8}, 50}),
      suite("pulse 1, 1.5, -1 times, least stroke at 0.3 g",
            {pulse, times(1.5, pulse), times(-1, pulse)}, {1000, 10, 0.2, 0.3}),
      suite("half-sines of 0.3, 0.6, 1 s", {sine(0.3, 1), sine(0.6, 1), sine(1, 1)},
            {400, 2, 0.05}),
      suite("seven: both scaled by 0.7 to 1.3, mean", seven, {300, 5, 0.1}),
      suite("seven: both scaled by 0.7 to 1.3, mean", seven, {300, 20, {}, {}, {2.8, 2.8}, 100}),
      suite("both, period 2 to 4 s", both, {400, 5, 0.1, {}, {2, 4}})};
  if (more) {
    const std::vector<SuiteRecord> recorded = read_suite(*more);
    all.push_back(suite("recorded", recorded, {350, 20, 0.05}));
    all.push_back(suite("recorded", recorded, {350, 20, {}, {}, {2.8, 2.8}, 100}));
  }
  return all;
}

}  // namespace stillpoint::bench
