// SPDX-License-Identifier: MIT
#include "record/suite.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace stillpoint::design {

double peak_load(const SuiteRecord& record) {
  return std::abs(record.scale) * records::peak_acceleration(record.record);
}

double peak_load(const std::vector<SuiteRecord>& records) {
  double most = 0;
  for (const SuiteRecord& record : records) {
    most = std::max(most, peak_load(record));
  }
  return most;
}

std::string suite_words(const LoadCase& load_case) {
  const std::size_t count = load_case.records.size();
  return count > 1 ? fmt::format("{} of {} records",
                                 load_case.combine == Combine::max ? "Largest" : "Mean", count)
                   : fmt::format("Under the {}", load_case.v0      ? "hit"
                                                 : load_case.pulse ? "pulse"
                                                                   : "record");
}

Record scaled(const SuiteRecord& record) {
  Record load = record.record;
  for (double& value : load.values) {
    value *= record.scale;
  }
  return load;
}

std::vector<CaseMotion> motions_of(const LoadCase& load_case) {
  std::vector<CaseMotion> list;
  for (const SuiteRecord& record : load_case.records) {
    list.push_back({record.name, record.scale, {}, {}, scaled(record)});
  }
  if (load_case.pulse) {
    list.push_back({std::string(name(*load_case.pulse)),
                    1,
                    {},
                    load_case.pulse,
                    excitation(*load_case.pulse)});
  } else if (load_case.v0) {
    list.push_back({"hit", 1, {0, *load_case.v0}, {}, NoExcitation{}});
  }
  return list;
}

double peak_load(const Excitation& load) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.k; }) {
          return std::abs(kind.k);
        } else if constexpr (requires { kind.values; }) {
          return records::peak_acceleration(kind);
        } else {
          return 0.0;
        }
      },
      load);
}

double peak_load(const LoadCase& load_case, double p) {
  return load_case.pulse ? peak_load(*load_case.pulse)
         : load_case.v0  ? p * *load_case.v0
                         : peak_load(load_case.records);
}

Oscillator oscillator_of(const RecordDesignRequest& request, const SuiteDamper& damper) {
  const double zeta = std::lerp(request.zeta.low, request.zeta.high, damper.damping);
  return {damper.p, damper.f, damper.delta, request.hold, zeta, request.breakaway};
}

SimulationRequest motion_of(const RecordDesignRequest& request, const SuiteDamper& damper,
                            const CaseMotion& motion) {
  SimulationRequest simulation;
  simulation.oscillator = oscillator_of(request, damper);
  simulation.start = motion.start;
  simulation.surface.notch_width = damper.delta > 0 ? damper.notch_width() : std::nullopt;
  simulation.excitation = motion.load;
  return simulation;
}

void require_valid(const LoadCase& load_case) {
  if (load_case.v0) {
    require_within("v0", *load_case.v0, smallest_speed, largest_speed);
    return;
  }
  if (load_case.pulse) {
    require_within("k", peak_load(*load_case.pulse), smallest_speed, largest_speed);
    require_valid(excitation(*load_case.pulse));
    return;
  }
  if (load_case.records.empty()) {
    throw InputError::missing("records", "give at least one");
  }
  for (const SuiteRecord& record : load_case.records) {
    require_within("scale", std::abs(record.scale), smallest_speed, largest_speed);
    require_valid(Excitation(record.record));
  }
}

double load_part(double load, double own_weakest, double weakest) {
  return weakest < 1 ? 1 - (1 - load) * (1 - own_weakest) / (1 - weakest) : 1;
}

double weakest_load(const RecordDesignRequest& request) {
  double least = 1;
  for (const LoadCase& each : request.cases) {
    least = std::min(least, each.weakest);
  }
  return std::max(least_weakest, least);
}

double weakest_part(const LoadCase& load_case, const SuiteDamper& damper) {
  const double least = std::max(least_weakest, load_case.weakest);
  if (load_case.weakest > 0 || !load_case.v0 || damper.width > 0) {
    return least;
  }
  constexpr double decided = 1 + 1e-5;  // far enough above the edge for least_suite_margin
  return std::clamp(std::sqrt(2 * damper.delta) / *load_case.v0 * decided, least, 1.0);
}

double load_part(const RecordDesignRequest& request, std::size_t in_case,
                 const SuiteDamper& damper) {
  return load_part(damper.load, weakest_part(request.cases[in_case], damper),
                   weakest_load(request));
}

CaseMotion weakened(CaseMotion motion, double part) {
  motion.start.v0 *= part;
  std::visit(
      [part]<class Kind>(Kind& kind) {
        if constexpr (requires { kind.k; }) {
          kind.k *= part;
        }
      },
      motion.load);
  return motion;
}

}  // namespace stillpoint::design
