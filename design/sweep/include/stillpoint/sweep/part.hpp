// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// Far more than a cluster should have to start.
inline constexpr std::int64_t most_sweep_parts = 1'000'000;

/// One of the parts that a sweep is split into: consecutive entries, whose numbers differ by at
/// most one. Joined in order by merge() they are the whole sweep.
struct SweepPart {
  std::int64_t number{1};  ///< 1 to count
  std::int64_t count{1};

  friend bool operator==(const SweepPart&, const SweepPart&) = default;
};

/// "3/8"
[[nodiscard]] std::string text(const SweepPart& part);

/// Throws InputError unless it is I/N with 1 <= I <= N <= most_sweep_parts.
[[nodiscard]] SweepPart parse_part(std::string_view text);

/// Entries first <= i < first + count.
struct EntryRange {
  std::int64_t first{0};
  std::int64_t count{0};
};

/// The entries of the part, in a sweep of this many entries.
[[nodiscard]] EntryRange range_of(const SweepPart& part, std::int64_t entries);

/// The path with "3-of-8" for {part}, padded with zeros to the width of the last part.
[[nodiscard]] std::string with_part(std::string path, const SweepPart& part);

}  // namespace stillpoint::sweep
