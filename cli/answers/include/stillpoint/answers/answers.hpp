// SPDX-License-Identifier: MIT
#pragma once

// The tasks of design and region after a hit, their answers, and the exit code of any answer.

#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::answers {

/// The parts to choose from, and the file that names them.
struct PartsOfFile {
  std::string file;
  std::vector<design::Part> parts;
};

/// `physical` if the task was given in metres and seconds.
struct DesignTask {
  design::DesignRequest request;
  std::optional<design::PhysicalInput> physical{};
  std::optional<PartsOfFile> catalogue{};
  std::optional<design::NotchShape> notch{};  ///< the notch that will be built
  std::optional<std::int64_t> trade_offs{};   ///< points of the front; not with a pulse
};

struct RegionTask {
  design::RegionRequest request;
  std::optional<design::PhysicalInput> physical{};
  std::optional<PartsOfFile> catalogue{};
};

/// Each throws InputError for wrong numbers.
[[nodiscard]] report::DesignReport answer(DesignTask task);
[[nodiscard]] report::RegionReport answer(RegionTask task);

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< the shells' code for SIGINT
};

/// 3 without an admissible design, 4 if the cross-check failed, else 0.
[[nodiscard]] ExitCode exit_code(const report::DesignReport& report);
/// The same; 130 for a search that was interrupted. A region that judges a damper is an answer.
[[nodiscard]] ExitCode exit_code(const report::RecordDesignReport& report);
[[nodiscard]] ExitCode exit_code(const report::RegionReport& report);
/// Of any other answer.
template <class Report>
[[nodiscard]] ExitCode exit_code(const Report& /*report*/) {
  return exit_done;
}

}  // namespace stillpoint::answers
