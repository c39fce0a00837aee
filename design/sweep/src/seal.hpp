// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/part_label.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace stillpoint::sweep {

/// The last line of the file of a part, behind its rows: which part of which sweep it is, and what
/// comes before. The line ends with the number of bytes before it, in 20 digits, so that it can be
/// found from the end of the file. A file without it is not a complete part. Readers of CSV can
/// take it for a comment, and readers of .npy do not look beyond the rows.
struct Seal {
  PartLabel label;
  RowFormat format{RowFormat::csv};
  std::string npy_fields;  ///< of format npy, see npy.hpp
  std::int64_t header{0};  ///< bytes before the rows
  SweepState state;        ///< of the part; its bytes are those before the seal
};

/// What a seal and a checkpoint keep of a state under the same keys.
void read_counts(const nlohmann::ordered_json& document, SweepState& state);

[[nodiscard]] std::string text(const Seal& seal);

/// Of a part that ends in `state`.
[[nodiscard]] Seal seal_of(const SweepSpec& spec, const SweepState& state);

/// Throws FileError, of kind "part", if the file cannot be read or does not end in a seal.
[[nodiscard]] Seal read_seal(const std::string& path);

}  // namespace stillpoint::sweep
