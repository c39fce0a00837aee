// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/part_label.hpp>
#include <stillpoint/sweep/state.hpp>

#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// How far which sweep got: one line of JSON, the same beside rows that are not complete, in
/// FILE.part.json, and behind those of a complete part. Readers of CSV can take that line for a
/// comment, and readers of .npy do not look beyond the rows.
struct Checkpoint {
  PartLabel label;
  SweepState state;
};

[[nodiscard]] std::string text(const Checkpoint& checkpoint);
/// Throws std::exception if it is not one.
[[nodiscard]] Checkpoint parse_checkpoint(std::string_view text);

/// The last line of a part: a mark, the checkpoint, and the number of bytes before the line, in 20
/// digits, so that it is found from the end of the file. A file without it is not a complete part.
[[nodiscard]] std::string seal(const Checkpoint& checkpoint);

/// Throws FileError, of kind "part", if the file cannot be read or does not end in a seal.
[[nodiscard]] Checkpoint read_seal(const std::string& path);

}  // namespace stillpoint::sweep
