// SPDX-License-Identifier: MIT
#pragma once

// Sizes and looks of the chart. Colours are those of Okabe and Ito, which the colour-blind tell
// apart, darker on white and lighter on black; marks differ too.

#include <string_view>

namespace stillpoint::bench {

inline constexpr double width = 860;
inline constexpr double top = 96;  // title and legend
inline constexpr double panel_width = 418;
inline constexpr double panel_height = 270;
inline constexpr double left_margin = 56;  // of a panel, for the labels of time
inline constexpr double upper_margin = 30;
inline constexpr double plot_width = panel_width - left_margin - 14;
inline constexpr double plot_height = panel_height - upper_margin - 46;
inline constexpr int columns = 2;

inline constexpr int least_error = -17;  // decades of the error axis
inline constexpr int largest_error = 2;

inline constexpr std::string_view style = R"(<style>
text { font-family: system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif; font-size: 12px; fill: #333 }
.title { font-size: 17px; font-weight: 600 }
.scene { font-size: 13px; font-weight: 600 }
.tick { font-size: 11px; fill: #555 }
.paper { fill: #fff }
.frame { fill: none; stroke: #999 }
.grid { stroke: #e4e4e4 }
.line { fill: none; stroke-width: 1.8 }
.wrong { stroke-width: 1.3 }
.stillpoint { color: #c04a00 }
.dopri5 { color: #0072b2 }
.RK4 { color: #a66f00 }
.rk8pd { color: #00805c }
.CVODE { color: #a0527f }
.regularised { color: #555 }
@media (prefers-color-scheme: dark) {
text { fill: #ddd }
.tick { fill: #aaa }
.paper { fill: #0d1117 }
.frame { stroke: #777 }
.grid { stroke: #2a2f36 }
.stillpoint { color: #ff8a3d }
.dopri5 { color: #56b4e9 }
.RK4 { color: #f0b429 }
.rk8pd { color: #2bc492 }
.CVODE { color: #e39ac4 }
.regularised { color: #b0b0b0 }
}
</style>
)";

}  // namespace stillpoint::bench
