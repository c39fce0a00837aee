// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/map.hpp>
#include <stillpoint/sweep/sink.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

#include <cstdint>
#include <functional>
#include <stop_token>

namespace stillpoint::sweep {

/// What observes a sweep while it runs.
struct SweepWatch {
  std::stop_token stop{};                             ///< obeyed within some tenths of a second
  std::function<void(const SweepState&)> progress{};  ///< called after each block
  SweepMap* map{nullptr};                             ///< to be filled
};

enum class SweepEnd {
  complete,
  stopped,         ///< the rows so far can be resumed, see RowSink::leave
  stopped_in_map,  ///< the rows are complete, the map is not
};

/// How a sweep went.
struct SweepSummary {
  SweepEnd end{SweepEnd::complete};
  SweepState state;
  std::int64_t resumed_at{0};  ///< the rows that an interrupted sweep had left
  double wall_time_s{0};       ///< of this run only
};

/// Runs a sweep from where its sink is to the end. The rows are those that free_response,
/// forced_response and design::search give one by one, to the last bit.
///
/// Throws InputError for a spec that is not valid, EntryError for an entry of a grid that is
/// refused, and records::FileError for a wrong line of a list and for a file that cannot be
/// written. The rows before that are written, and the sink is left so that a file can be resumed.
SweepSummary run(const SweepSpec& spec, RowSink& sink, const SweepWatch& watch = {});

}  // namespace stillpoint::sweep
