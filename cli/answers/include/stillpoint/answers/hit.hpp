// SPDX-License-Identifier: MIT
#pragma once

// The tasks of design and region after a hit, and their answers.

#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/region.hpp>
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

}  // namespace stillpoint::answers
