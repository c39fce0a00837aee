// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/part.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// Which part of which sweep a file is, and how far it got: one line of JSON, the same beside rows
/// that are not complete, in FILE.part.json, and behind those of a complete part, where it is the
/// seal. Readers of CSV can take that line for a comment, and readers of .npy do not look beyond
/// the rows. A part that keeps no rows is its seal alone.
struct Checkpoint {
  std::string path{};  ///< of the file; not in the line
  std::string task{};  ///< SweepSpec::identity
  SweepKind kind{};
  SweepPart part{};
  ListExtent whole{};  ///< entries of the whole sweep, and the digest of a list; 0 if not counted
  SweepState state{};

  /// How many entries the part has if it is complete; empty if there is no such part.
  [[nodiscard]] std::optional<std::int64_t> rows() const;
};

/// SweepSpec::identity of a spec that is otherwise complete: everything that a result depends on,
/// as a JSON object. `inputs` is a JSON object with everything that was given and decides the
/// numbers; `version` is that of the program that computes them.
[[nodiscard]] std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                                      std::string_view version);

/// Of a sweep that begins; the path is that of its output. Throws InputError unless its identity is
/// a JSON object.
[[nodiscard]] Checkpoint beginning(const SweepSpec& spec);

/// Empty if both belong to the same sweep in as many parts, else how they differ: "f was 0:1:10, is
/// 0:1:20".
[[nodiscard]] std::string difference(const Checkpoint& one, const Checkpoint& other);

[[nodiscard]] std::string text(const Checkpoint& checkpoint);
/// Throws std::exception if it is not one.
[[nodiscard]] Checkpoint parse_checkpoint(std::string_view text);

/// The last line of a part: a mark, the checkpoint, its digest, and the number of bytes before the
/// line, in 20 digits each, so that it is found from the end of the file. A file without it is not
/// a complete part.
[[nodiscard]] std::string seal(const Checkpoint& checkpoint);

/// Throws FileError, of kind "part", if the file cannot be read or does not end in a seal.
[[nodiscard]] Checkpoint read_seal(const std::string& path);

}  // namespace stillpoint::sweep
