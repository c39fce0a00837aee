// SPDX-License-Identifier: MIT
#include <stillpoint/report/version.hpp>

#include <stillpoint/design/search.hpp>

#include <fmt/format.h>

namespace stillpoint::report {

std::string program_version() {
  return STILLPOINT_VERSION;
}

std::string version_line() {
  return fmt::format("stillpoint {} (NLopt {}, {} build, {})", program_version(),
                     design::nlopt_version(), STILLPOINT_BUILD_TYPE, STILLPOINT_COMPILER);
}

}  // namespace stillpoint::report
