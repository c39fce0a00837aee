// SPDX-License-Identifier: MIT
#include <stillpoint/report/progress_words.hpp>

#include <fmt/format.h>

#include <cstdint>

namespace stillpoint::report {

std::string progress_in_tau(double tau, double end) {
  return end > 0 ? fmt::format("tau {:.6g} of {:.6g}, {:.0f} %", tau, end, 100 * tau / end)
                 : fmt::format("tau {:.6g}", tau);
}

std::string time_left(double seconds) {
  const auto minutes = static_cast<std::int64_t>(seconds / 60);
  return fmt::format(", {}:{:02.0f} left", minutes, seconds - 60 * static_cast<double>(minutes));
}

}  // namespace stillpoint::report
