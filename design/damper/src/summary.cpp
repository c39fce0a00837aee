// SPDX-License-Identifier: MIT
#include <stillpoint/design/design.hpp>

#include <fmt/format.h>

namespace stillpoint::design {

std::string summary(const DesignResult& result) {
  if (!result.finding) {
    return "no damper: " + result.reason;
  }
  const Finding& found = *result.finding;
  return fmt::format("f = {:.6g}, delta = {:.6g} within {:.3g} %: {}{}", found.point.f,
                     found.point.delta, 100 * found.point.tolerance, summary(found.response),
                     found.cross_check.passed ? "" : "; the cross-check failed");
}

}  // namespace stillpoint::design
