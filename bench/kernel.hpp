// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::bench {

/// This project's kernel with all that it computes by default: counts, peaks, times, margin. A
/// scene without excitation goes to free_response, the others to forced_response up to t_end.
[[nodiscard]] peers::Result kernel(const peers::Scene& scene);

}  // namespace stillpoint::bench
