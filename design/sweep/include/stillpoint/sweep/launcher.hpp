// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/part.hpp>

#include <cstdint>
#include <functional>
#include <optional>

namespace stillpoint::sweep {

/// The value of an environment variable; null if it is not set.
using Environment = std::function<const char*(const char* name)>;

/// The part of this process, from what its launcher sets: Open MPI, MPICH, a step or an
/// array of Slurm, GNU parallel. GNU parallel does not say how many jobs there are, so it needs
/// `count`; for the others it must agree with theirs. Throws InputError if no launcher gives a
/// part, if two contradict each other, and for a value that makes no sense.
[[nodiscard]] SweepPart launched_part(const Environment& environment,
                                      std::optional<std::int64_t> count = {});

/// The part that "I/N", "auto" or "auto/N" asks for; "auto" is that of launched_part(). Throws
/// InputError for anything else.
[[nodiscard]] SweepPart asked_part(const std::string& asked, const Environment& environment);

}  // namespace stillpoint::sweep
