// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/suite_task.hpp>

namespace stillpoint::design {

/// Whether what is asked sees what a notch does to the mass: under records an acceleration needs a
/// width, or a limit of the jumps; after hits and pulses it is the one outside the notch.
[[nodiscard]] bool counts_the_notch(const RecordDesignRequest& request);

/// Sets the frictions with which the loads that must start the mass do. Throws InputError.
void bound_starts(RecordDesignRequest& request);

/// The largest f with which a mass that may rest off centre after a hit is not held beyond its
/// stroke, whose spring has that p; HUGE_VAL without such a case. More of it is a brake.
[[nodiscard]] double most_in_dead_zone(const RecordDesignRequest& request, double p);
/// The softest p of the box of a damper.
[[nodiscard]] double softest(const RecordDesignRequest& request, double p);

/// A valid request with the ranges and the combination that it leaves open. Throws InputError.
[[nodiscard]] RecordDesignRequest completed(RecordDesignRequest request);

/// The same without the ends of f and Delta that the load and the limits do not set.
[[nodiscard]] RecordDesignRequest with_open_friction(RecordDesignRequest task);

}  // namespace stillpoint::design
