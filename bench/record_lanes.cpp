// SPDX-License-Identifier: MIT

// Measures motions under a record, side by side in lanes and one after another: docs/batch.md.
// 256 random dampers with periods from 1.5 s to 4.5 s, one thread, processor time in nanoseconds
// for a sample and damper, everything included.
//
//   stillpoint_record_lanes [ROUNDS] RECORD...
//
// Each round measures everything once, and the shortest time of each counts, since other work of
// the machine can only add to it.

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/record_batch.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/record_scaling.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <exception>
#include <filesystem>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::bench {

namespace {

constexpr Eigen::Index dampers = 256;
constexpr double never = 1e300;

/// A range of dampers; f in g, delta and width in g s^2, so that 0.01 is 98 mm.
struct Kind {
  std::string_view name;
  double least_f;
  double greatest_f;  ///< of the largest load where it is below 0: -0.5 is half of it
  double greatest_delta;
  std::optional<double> hold;
  double greatest_width{0};
  double zeta{0};
};

constexpr Kind kinds[] = {
    {"f from 0.005 to 0.02, no notch", 0.005, 0.02, 0, {}},
    {"f from 0 to the largest load, no notch", 0, -1, 0, {}},
    {"f from 0 to half of it, Delta up to 0.01", 0, -0.5, 0.01, {}},
    {"f from 0.005 to 0.05, Delta up to 0.001, a notch that holds 0.1 g", 0.005, 0.05, 0.001, 0.1},
    {"f from 0.005 to 0.05, Delta up to 0.001, 0.001 to 0.01 wide", 0.005, 0.05, 0.001, {}, 0.01},
    {"f from 0 to half of the largest load, Delta up to 0.01, as wide", 0, -0.5, 0.01, {}, 0.01},
    {"no friction at all", 0, 0, 0, {}},
    {"f from 0.005 to 0.02, no notch, damping 5 %", 0.005, 0.02, 0, {}, 0, 0.05},
    {"f from 0 to half of it, Delta up to 0.01, damping 5 %", 0, -0.5, 0.01, {}, 0, 0.05},
};

struct Case {
  Case(const Kind& kind, const Record& load) : record(load), hold(kind.hold), zeta(kind.zeta) {
    std::mt19937_64 engine(1);
    const auto random = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
    };
    const double greatest =
        kind.greatest_f < 0 ? -kind.greatest_f * records::peak_acceleration(load) : kind.greatest_f;
    for (Eigen::Index i = 0; i < dampers; ++i) {
      p[i] = 2 * std::numbers::pi / random(1.5, 4.5);
      f[i] = random(kind.least_f, greatest);
      delta[i] = random(0, kind.greatest_delta);
    }
    if (kind.greatest_width > 0) {
      width.resize(dampers);
      for (double& one : width) {
        one = random(kind.greatest_width / 10, kind.greatest_width);
      }
    }
  }

  const Record& record;
  std::optional<double> hold;
  double zeta;
  Eigen::ArrayXd p{dampers};
  Eigen::ArrayXd f{dampers};
  Eigen::ArrayXd delta{dampers};
  Eigen::ArrayXd width;
};

/// Processor time in nanoseconds for a sample and damper.
template <class Action>
double timed(const Record& record, const Action& action) {
  const std::clock_t begin = std::clock();
  action();
  return static_cast<double>(std::clock() - begin) * (1e9 / CLOCKS_PER_SEC) /
         (dampers * static_cast<double>(record.values.size()));
}

double in_lanes(const Case& one, RecordBatchResult& result) {
  return timed(one.record, [&] {
    RecordBatchOptions options{.hold = one.hold, .notch_width = one.width, .threads = 1};
    if (one.zeta > 0) {
      options.zeta = Eigen::ArrayXd::Constant(dampers, one.zeta);
    }
    record_batch(0, one.p, one.f, one.delta, one.record, options, result);
  });
}

double one_by_one(const Case& one) {
  const Excitation load = one.record;
  return timed(one.record, [&] {
    for (Eigen::Index i = 0; i < dampers; ++i) {
      Oscillator oscillator{one.p[i], one.f[i], one.delta[i]};
      oscillator.hold = one.hold;
      oscillator.zeta = one.zeta;
      Surface surface;
      if (one.width.size() > 0) {
        surface.notch_width = one.width[i];
      }
      (void)forced_response(oscillator, {}, load, {}, surface);
    }
  });
}

struct Measured {
  std::optional<double> events;  ///< turns, sticks and passages of a motion that stops
  double scalar{never};
  double lanes{never};
};

Measured measured(const Case& one, int rounds) {
  Measured least;
  RecordBatchResult result;
  for (int round = 0; round < rounds; ++round) {
    least.scalar = std::min(least.scalar, one_by_one(one));
    least.lanes = std::min(least.lanes, in_lanes(one, result));
  }
  if ((result.outcome != Outcome::never_stops).all()) {
    least.events =
        (result.half_cycles.sum() + result.turning_points.sum() + result.sticks.sum()) / dampers;
  }
  return least;
}

void print_kinds(const std::vector<Record>& records, int rounds) {
  for (const Kind& kind : kinds) {
    fmt::print("| {} |", kind.name);
    for (const Record& record : records) {
      const Measured least = measured(Case(kind, record), rounds);
      fmt::print(" {}{:.2f}, {:.2f} |", least.events ? fmt::format("{:.0f}, ", *least.events) : "",
                 least.scalar, least.lanes);
    }
    fmt::print("\n");
  }
}

void run(int rounds, const std::vector<std::string>& paths) {
  std::vector<Record> records;
  records.reserve(paths.size());
  fmt::print("| dampers |");
  for (const std::string& path : paths) {
    records.push_back(records::read_record(path).record);
    fmt::print(" {} |", std::filesystem::path(path).filename().string());
  }
  fmt::print("\n|---|");
  for (std::size_t i = 0; i < paths.size(); ++i) {
    fmt::print("---|");
  }
  fmt::print("\n");
  print_kinds(records, rounds);
}

}  // namespace

}  // namespace stillpoint::bench

int main(int argc, char** argv) {
  std::vector<std::string> paths(argv + 1, argv + argc);
  int rounds = 21;
  if (!paths.empty() &&
      std::from_chars(paths[0].data(), paths[0].data() + paths[0].size(), rounds).ec ==
          std::errc{}) {
    paths.erase(paths.begin());
  }
  try {
    stillpoint::bench::run(std::max(1, rounds), paths);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stillpoint_record_lanes: {}\n", error.what());
    return 1;
  }
  return 0;
}
