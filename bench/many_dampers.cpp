// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/record_batch.hpp>
#include <stillpoint/peers/methods.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <variant>

namespace stillpoint::bench {

namespace {

constexpr int records = 11;
constexpr Eigen::Index side = 100;   // of the grid of f and delta
constexpr Eigen::Index every = 101;  // is run one by one: along a diagonal of the grid
constexpr double half_cycles = 10'000;

struct Dampers {
  Eigen::ArrayXd p{Eigen::ArrayXd::Ones(side * side)};
  Eigen::ArrayXd f{side * side};
  Eigen::ArrayXd delta{side * side};

  /// With their squares, as the scan of a record design.
  Dampers() {
    for (Eigen::Index i = 0; i < side * side; ++i) {
      const Eigen::Index row = i / side;
      const double along = static_cast<double>(row) / side;
      const double across = static_cast<double>(i % side) / side;
      f[i] = 0.005 + 0.195 * along *
                         along;  // less friction makes thousands of half-cycles after the record
      delta[i] = 0.1 * across * across;
    }
  }
};

std::vector<Record> eleven(const Record& record) {
  std::vector<Record> list;
  list.reserve(records);
  for (int i = 0; i < records; ++i) {
    Record& one = list.emplace_back(record);
    one.step *= 0.8 + 0.04 * i;
    for (double& value : one.values) {
      value *= 1.5 - 0.1 * i;
    }
  }
  return list;
}

/// For the dampers run one by one: under one record, to its end.
peers::Scene scene(const Dampers& dampers, Eigen::Index i, const Record& record) {
  return {{dampers.p[i], dampers.f[i], dampers.delta[i]},
          {},
          record,
          record.step * static_cast<double>(record.values.size() - 1)};
}

peers::Result runge_kutta(const peers::Scene& scene) {
  return peers::runge_kutta4(scene, std::get<Record>(scene.excitation).step);
}

}  // namespace

ManyDampers many_dampers(const Record& record, const peers::MeasureOptions& options) {
  const Dampers dampers;
  const std::vector<Record> list = eleven(record);
  std::vector<peers::Scene> scenes;
  for (const Record& one : list) {
    for (Eigen::Index i = 0; i < side * side; i += every) {
      scenes.push_back(scene(dampers, i, one));
    }
  }
  volatile double sink = 0;
  const std::vector<std::function<void()>> calls{
      [&] {
        RecordBatchResult found;
        const RecordBatchOptions one_thread{.half_cycle_limit = half_cycles, .threads = 1};
        for (const Record& one : list) {
          record_batch(0, dampers.p, dampers.f, dampers.delta, one, one_thread, found);
          sink = found.peak_amplitude[0];
        }
      },
      [&] {
        const ForcedOptions to_rest{.half_cycle_limit = half_cycles};
        for (const peers::Scene& one : scenes) {
          sink = forced_response(one.oscillator, one.start, one.excitation, to_rest).peak_amplitude;
        }
      },
      [&] {
        for (const peers::Scene& one : scenes) {
          sink = runge_kutta(one).peak;
        }
      },
  };
  std::vector<peers::Timing> timings = measure(calls, options);
  ManyDampers found;
  found.sampled = static_cast<double>(scenes.size()) / records;
  found.samples = static_cast<double>(records) * static_cast<double>(record.values.size());
  for (std::size_t i = 1; i < timings.size(); ++i) {
    scale(timings[i], static_cast<double>(side * side) / found.sampled);
  }
  for (const peers::Scene& one : scenes) {
    const peers::Result exact = peers::kernel(one);
    const peers::Result peer = runge_kutta(one);
    found.error_of_peak = std::max(found.error_of_peak, std::abs(peer.peak - exact.peak));
    const bool right =
        peer.passages == exact.passages && peer.turns == exact.turns && peer.sticks == exact.sticks;
    found.wrong_counts += right ? 0 : 1 / static_cast<double>(scenes.size());
  }
  found.rows = {{"record_batch, in lanes", timings[0]},
                {"forced_response, one by one", timings[1]},
                {"RK4, a step of one sample", timings[2]}};
  return found;
}

}  // namespace stillpoint::bench
