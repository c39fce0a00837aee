// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/sink.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <memory>

namespace stillpoint::sweep {

/// The file of the sweep, or standard output. Throws FileError if it cannot be written, or another
/// sweep left a part of it that this one does not or cannot resume, and InputError if the format
/// needs a file or the spec is not valid.
[[nodiscard]] std::unique_ptr<RowSink> open_rows(const SweepSpec& spec);

/// Whether anything is kept while a sweep runs: its rows, or what a part of a reduction has so far.
[[nodiscard]] bool keeps_rows(const SweepSpec& spec);

/// Whether that goes to standard output.
[[nodiscard]] bool goes_to_standard_output(const SweepSpec& spec);

}  // namespace stillpoint::sweep
