// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/state.hpp>

#include "block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

void SweepBlock::cut(Eigen::Index count) {
  for (Eigen::ArrayXd& column : columns) {
    column.conservativeResize(std::min(count, column.size()));
  }
  const auto kept = static_cast<std::size_t>(count);
  lines.resize(std::min(kept, lines.size()));
  digests.resize(std::min(kept, digests.size()));
  size = count;
}

void ByteDigest::add(std::string_view bytes) {
  constexpr std::int64_t width = 8;
  Digest digest(words);
  const auto append = [&](std::string_view few) {
    for (const char byte : few) {
      rest |= std::uint64_t{static_cast<unsigned char>(byte)} << (8U * (size++ % width));
      if (size % width == 0) {
        digest.add(std::exchange(rest, 0));
      }
    }
  };
  const auto head =
      std::min(bytes.size(), static_cast<std::size_t>((width - size % width) % width));
  append(bytes.substr(0, head));
  bytes.remove_prefix(head);
  for (; bytes.size() >= width; bytes.remove_prefix(width), size += width) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), width);
    if constexpr (std::endian::native == std::endian::big) {
      word = __builtin_bswap64(word);
    }
    digest.add(word);
  }
  append(bytes);
  words = digest.value();
}

std::uint64_t digest(const Excitation& excitation) {
  Digest digest;
  if (const auto* const record = std::get_if<Record>(&excitation)) {
    digest.add(record->step);
    std::ranges::for_each(record->values, [&](double value) { digest.add(value); });
    std::ranges::for_each(record->times, [&](double time) { digest.add(time); });
  }
  return digest.value();
}

std::uint64_t digest(const std::vector<design::Part>& parts) {
  Digest digest;
  for (const design::Part& part : parts) {
    digest.add(part.f);
    digest.add(part.delta);
  }
  return digest.value();
}

void SweepState::add(const SweepBlock& block) {
  rows += block.size;
  digest = block.digest();
  if (block[Quantity::outcome].size() == block.size) {
    for (const double outcome : block[Quantity::outcome]) {
      ++outcomes[static_cast<std::size_t>(outcome)];
    }
  }
  if (block[Quantity::locked_from].size() == block.size) {
    locked += block[Quantity::locked_from].isFinite().count();
  }
  if (block[Quantity::feasible].size() == block.size) {
    feasible += static_cast<std::int64_t>(block[Quantity::feasible].sum());
  }
}

std::string summary(const SweepState& state, bool of_designs) {
  if (of_designs) {
    return fmt::format("{} of {} entries have an admissible design.", state.feasible, state.rows);
  }
  const auto count = [&state](Outcome outcome) { return state.outcomes[sweep_outcome(outcome)]; };
  const std::int64_t at_zero = count(Outcome::stopped_at_zero);
  const std::int64_t in_notch = count(Outcome::stopped_in_notch);
  std::string text =
      state.locked > 0
          ? fmt::format(
                "Locked: in {} of {} motions the notch holds the mass to the end of the "
                "load. {} stop ",
                state.locked, state.rows, at_zero + in_notch)
      : at_zero + in_notch == state.rows && state.rows > 1
          ? fmt::format("All {} motions stop ", state.rows)
          : fmt::format("{} of {} motions stop ", at_zero + in_notch, state.rows);
  text += in_notch == 0 ? "at x = 0" : at_zero == 0 ? "in the notch" : "at x = 0 or in the notch";
  const auto add = [&text](std::int64_t how_many, std::string_view one, std::string_view several) {
    if (how_many > 0) {
      text += fmt::format(", {} {}", how_many, how_many == 1 ? one : several);
    }
  };
  add(count(Outcome::stopped_in_dead_zone), "off centre", "off centre");
  add(count(Outcome::caught_at_start), "never starts", "never start");
  add(count(Outcome::never_stops), "never stops", "never stop");
  add(count(Outcome::running), "is not known to have stopped", "are not known to have stopped");
  add(state.outcomes[too_many_half_cycles], "has too many half-cycles",
      "have too many half-cycles");
  return text + ".";
}

}  // namespace stillpoint::sweep
