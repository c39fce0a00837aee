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

struct Task {
  SuiteObjective objective{SuiteObjective::acceleration};
  double stroke_mm{0};
  double residual_mm{0};
  std::optional<double> acceleration{};
  std::optional<double> hold{};
  std::optional<Interval> width_mm{};
  Interval periods_s{2.8, 2.8};
  std::optional<Interval> f{};
};

/// A notch without a width may have any jump.
constexpr double any_jump = 1e3;

NamedSuite suite(const std::string& name, std::vector<SuiteRecord> records, const Task& task) {
  constexpr double mm = 1e-3 * metre;
  RecordDesignRequest request{.cases = {{.records = std::move(records)}}};
  request.objective = task.objective;
  request.p = {2.8 / task.periods_s.high, 2.8 / task.periods_s.low};
  request.cases.front().limits = {
      task.stroke_mm * mm, task.acceleration, task.residual_mm * mm, {}, {}};
  request.hold = task.hold;
  request.f = task.f;
  if (task.width_mm) {
    request.width = Interval{task.width_mm->low * mm, task.width_mm->high * mm};
  } else {
    request.cases.front().limits.jump = any_jump;
  }
  const bool has_size = task.objective == SuiteObjective::robust;
  return {
      std::string(design::name(task.objective)),
      fmt::format("{}; stroke {} mm, rest within {} mm{}", name, task.stroke_mm, task.residual_mm,
                  task.acceleration ? fmt::format(", {} g", *task.acceleration) : ""),
      std::move(request), has_size ? std::vector{0.1} : std::vector{0.05, 0.1, 0.2}};
}

NamedSuite exact(NamedSuite suite) {
  suite.part = "exact " + suite.part;
  suite.tolerances = {0};
  return suite;
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
  const auto in_mm = [](double width) { return 1e3 * width / metre; };
  return request.width && request.width->low < request.width->high
             ? fmt::format("{:.4g} to {:.4g} mm wide", in_mm(request.width->low),
                           in_mm(request.width->high))
         : request.width ? fmt::format("{:.4g} mm wide", in_mm(request.width->low))
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
  const std::vector pulses{pulse, times(1.5, pulse), times(-1, pulse)};
  const std::vector sines{sine(0.3, 1), sine(0.6, 1), sine(1, 1)};
  // Without a friction that is always there, any small one would rest at 0 for nothing.
  constexpr Interval rubbing{0.03, 0.3};
  const std::string of_seven = "seven: both scaled by 0.7 to 1.3, mean";
  const std::string of_pulses = "pulse 1, 1.5, -1 times";
  const std::string of_sines = "half-sines of 0.3, 0.6, 1 s";
  const std::string any_period = "both, period 2 to 4 s";
  constexpr auto acceleration = SuiteObjective::acceleration;
  constexpr auto amplitude = SuiteObjective::amplitude;
  constexpr auto residual = SuiteObjective::residual;
  constexpr auto robust = SuiteObjective::robust;
  constexpr Interval one_period{2.8, 2.8};
  constexpr Interval periods{2, 4};
  constexpr Interval narrow{50, 50};
  constexpr Interval wide{100, 100};
  constexpr Interval any_width{20, 200};
  std::vector<NamedSuite> all{
      suite("both", both, {acceleration, 300, 5}),
      suite("both", both, {acceleration, 400, 5, {}, 0.1}),
      suite("both", both, {acceleration, 400, 30, {}, {}, narrow}),
      suite("both", both, {acceleration, 400, 30, {}, {}, any_width}),
      suite(of_sines, sines, {acceleration, 400, 2, {}, 0.05}),
      suite(of_sines, sines, {acceleration, 400, 100, {}, {}, any_width}),
      suite(of_seven, seven, {acceleration, 300, 5, {}, 0.1}),
      suite(of_seven, seven, {acceleration, 300, 20, {}, {}, wide}),
      suite(any_period, both, {acceleration, 400, 5, {}, 0.1, {}, periods}),
      suite(any_period, both, {acceleration, 400, 30, {}, {}, narrow, periods}),

      suite(of_pulses, pulses, {amplitude, 1000, 10, 0.3, 0.2}),
      suite("both", both, {amplitude, 400, 30, 0.25, {}, narrow}),
      suite(of_sines, sines, {amplitude, 400, 100, 0.37, {}, any_width}),
      suite(any_period, both, {amplitude, 400, 30, 0.25, 0.1, {}, periods}),

      suite("both", both, {residual, 300, 60, 0.25, {}, {}, one_period, rubbing}),
      suite(of_pulses, pulses, {residual, 400, 50, 0.4, {}, narrow, one_period, rubbing}),
      suite(of_sines, sines, {residual, 400, 100, 0.37, {}, any_width, one_period, rubbing}),
      suite(of_seven, seven, {residual, 300, 20, 0.3, {}, wide}),
      suite(any_period, both, {residual, 400, 60, 0.25, 0.1, {}, periods, rubbing}),

      suite("both", both, {robust, 400, 30, 0.28, 0.1}),
      suite("both", both, {robust, 400, 30, 0.26, {}, narrow}),
      suite(of_sines, sines, {robust, 400, 100, 0.37, {}, any_width}),
      suite(of_seven, seven, {robust, 300, 20, 0.28, {}, wide}),
      suite(any_period, both, {robust, 400, 30, 0.25, 0.1, {}, periods}),

      exact(suite("both", both, {acceleration, 400, 30, {}, {}, narrow})),
      exact(suite("both", both, {acceleration, 400, 5, {}, 0.1})),
      exact(suite(of_pulses, pulses, {amplitude, 1000, 10, 0.3, 0.2})),
      exact(suite(of_seven, seven, {residual, 300, 20, 0.3, {}, wide}))};
  if (more) {
    const std::vector<SuiteRecord> records = read_suite(*more);
    for (const Task& task :
         {Task{acceleration, 350, 20, {}, 0.05}, Task{acceleration, 350, 20, {}, {}, wide},
          Task{acceleration, 350, 20, {}, {}, any_width},
          Task{acceleration, 350, 20, {}, 0.05, {}, periods},
          Task{amplitude, 350, 20, 0.25, {}, wide}, Task{residual, 350, 20, 0.25, {}, wide},
          Task{residual, 350, 20, 0.25, {}, {}, one_period, rubbing},
          Task{robust, 350, 20, 0.25, {}, wide}}) {
      const bool any = task.periods_s.low < task.periods_s.high;
      all.push_back(suite(any ? "recorded, period 2 to 4 s" : "recorded", records, task));
    }
  }
  return all;
}

}  // namespace stillpoint::bench
