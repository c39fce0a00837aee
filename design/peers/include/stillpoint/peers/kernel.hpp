// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::peers {

/// This project's kernel with all that it computes by default: counts, peaks, times, margin. A
/// scene without excitation goes to free_response, the others to forced_response up to t_end.
[[nodiscard]] Result kernel(const Scene& scene);

}  // namespace stillpoint::peers
