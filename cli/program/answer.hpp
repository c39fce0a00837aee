// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/answers/answer.hpp>

#include <functional>
#include <memory>

namespace stillpoint::cli {

using GoOn = std::function<bool()>;

/// The motion of simulate, with a trajectory if samples or an end were given.
[[nodiscard]] report::MotionReport motion_report(const Settings& settings, const GoOn& go_on);

/// design, region, simulate or spectrum. `go_on` is called now and then; returning false ends the
/// run with what there is. Throws InputError, UsageError and FileError.
[[nodiscard]] std::unique_ptr<answers::Answer> answer(Command command, const Settings& settings,
                                                      const GoOn& go_on);

}  // namespace stillpoint::cli
