// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/sweep/quantity.hpp>
#include <stillpoint/sweep/reduction.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace stillpoint::sweep {

/// Tells one sequence of numbers from another: FNV-1a over words, with a mixing step because the
/// low bits of doubles are often 0. It does not protect against intent.
class Digest {
 public:
  Digest() = default;
  explicit Digest(std::uint64_t value) : value_(value) {}

  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::uint64_t word) {
    constexpr std::uint64_t prime = 0x100000001B3U;
    value_ = (value_ ^ word) * prime;
    value_ ^= value_ >> 29U;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_{0xCBF29CE484222325U};
};

/// For the values of a record, whose file may change; for other loads, the digest of nothing.
[[nodiscard]] std::uint64_t digest(const Excitation& excitation);
[[nodiscard]] std::uint64_t digest(const std::vector<design::Part>& parts);

struct SweepBlock;

/// The progress of a sweep.
struct SweepState {
  std::int64_t rows{0};
  std::uint64_t digest{0};  ///< of the entries of a list so far
  using Counts = std::array<std::int64_t, sweep_outcome_count>;
  Counts outcomes{};         ///< how many motions ended this way
  Counts locked_outcomes{};  ///< how many of them the notch holds while the load goes on
  std::int64_t feasible{0};  ///< of the design problems
  std::int64_t bytes{0};     ///< of the header and the rows so far
  std::int64_t header{0};    ///< bytes of it
  Reduction reduction{};     ///< of the rows so far, if they are not written

  /// Adds the results of one more block, but for its reduction.
  void add(const SweepBlock& block);
  /// Adds another part of the same sweep, but for its digest and its bytes; throws std::exception
  /// if it cannot be.
  void add(const SweepState& part);
  [[nodiscard]] std::int64_t locked() const {
    return std::accumulate(locked_outcomes.begin(), locked_outcomes.end(), std::int64_t{0});
  }
};

/// In one line: how many of the motions, or of the design problems, come out well.
[[nodiscard]] std::string summary(const SweepState& state, bool of_designs);

}  // namespace stillpoint::sweep
