// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.hpp"

#include <string>

namespace stillpoint::bench {

/// All figures, times in seconds.
[[nodiscard]] std::string json_report(const Comparison& comparison);

/// docs/performance.md. Every number in its sentences comes from the comparison.
[[nodiscard]] std::string markdown_report(const Comparison& comparison);

/// Time against error, a panel per scene and a line per method, as SVG.
[[nodiscard]] std::string chart(const Comparison& comparison);
/// The same, as a page that shows values under the pointer.
[[nodiscard]] std::string chart_page(const Comparison& comparison);

}  // namespace stillpoint::bench
