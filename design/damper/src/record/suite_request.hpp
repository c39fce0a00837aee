// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/suite_task.hpp>

namespace stillpoint::design {

/// Whether what is asked sees what a notch does to the mass: under records an acceleration needs a
/// width, or a limit of the jumps; after hits and pulses it is the one outside the notch.
[[nodiscard]] bool counts_the_notch(const RecordDesignRequest& request);

/// Sets the frictions with which the loads that must start the mass do. Throws InputError.
void bound_starts(RecordDesignRequest& request);

/// A valid request with the ranges and the combination that it leaves open. Throws InputError.
[[nodiscard]] RecordDesignRequest completed(RecordDesignRequest request);

}  // namespace stillpoint::design
