// SPDX-License-Identifier: MIT
#pragma once

// How the file of a record is read, and what is read.

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/records/units.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::records {

/// Units of the values in a file.
enum class RecordUnits { g, m_per_s2, cm_per_s2, mm_per_s2 };

/// "g", "m/s2", "cm/s2" or "mm/s2".
[[nodiscard]] std::span<const Named<RecordUnits>> enumerators(RecordUnits) noexcept;
using stillpoint::name;

/// The unit of the times in a file, and which of them a motion can follow, excitation.hpp. This is
/// checked while the file is read, so that an error can name the line.
struct RecordClock {
  std::string_view unit{"s"};
  double per_tau{1};  ///< how much of this unit is one tau; > 0
  double p{1};        ///< of the oscillator; > 0

  /// The shortest time between two values, rounded.
  [[nodiscard]] double shortest() const { return smallest_speed / std::min(p, 1.0) * per_tau; }
  [[nodiscard]] double latest() const { return largest_speed * per_tau; }
  /// The largest value in g.
  [[nodiscard]] double largest_load() const { return largest_speed * std::min(p, 1.0); }
  [[nodiscard]] bool reaches(double time) const { return time / per_tau <= largest_speed; }
  /// Whether the motion can tell `time` from `before`.
  [[nodiscard]] bool tells_apart(double before, double time) const {
    const double tau = time / per_tau - before / per_tau;
    return p * tau >= smallest_speed && tau >= smallest_speed;
  }
  [[nodiscard]] bool holds_step(double step) const { return reaches(step) && tells_apart(0, step); }
};

/// The texts of files by the names that stand for their paths.
using HeldFiles = std::map<std::string, std::string>;

struct RecordOptions {
  /// In the clock's unit, > 0; for a file with values alone. Any other refuses it, unless it may be
  /// for other files of the suite.
  std::optional<double> step{};
  bool step_for_others{false};
  /// If not given: what the file's header says, else g.
  std::optional<RecordUnits> units{};
  /// Of a file with several records, from 1; empty: the only one.
  std::optional<std::size_t> channel{};
  double scale{1};  ///< factor on every value; negative reverses it; not 0
  double gravity_m_per_s2{standard_gravity_m_per_s2};  ///< one g of the result
  RecordClock clock{};
  std::shared_ptr<const HeldFiles> held{};  ///< read in place of files of these names
};

/// An acceleration record as a motion takes it, and what the file says about it.
struct RecordFile {
  Record record;            ///< in g and tau, scaled; at least one value
  std::string description;  ///< what the file says of itself; may be empty
  RecordUnits units{RecordUnits::g};
  bool assumed_g{false};   ///< neither the file nor the options give the units
  bool takes_step{false};  ///< that of the options, which must have one
  std::string doubt{};     ///< what may be meant otherwise than it was read, to follow the path
};

/// "PEER", "ESM" and so on, "columns" last.
[[nodiscard]] std::vector<std::string_view> record_format_names();

/// Throws InputError, "record-scale", unless 1e-100 <= |scale| <= 1e100.
void require_scale(double scale);

inline constexpr std::size_t largest_record_bytes = std::size_t{64} << 20U;

/// Reads a record in any format of docs/records.md. FILE#2 is channel 2 of FILE, unless there is a
/// file of that name. Throws FileError, with the line, if the file is wrong or contradicts the
/// options, and InputError for a wrong or missing option.
[[nodiscard]] RecordFile read_record(const std::string& path, const RecordOptions& options = {});

/// The same from text that is in memory; `path` stands for it in errors, and its ending may tell
/// the format.
[[nodiscard]] RecordFile parse_record(std::string_view text, const std::string& path,
                                      const RecordOptions& options = {});

/// Whether a text is not a record, not even a wrong one: it matches no format, and neither of its
/// first two lines, comments and blank ones aside, begins with a number. Throws FileError if it is
/// empty or binary.
[[nodiscard]] bool is_plain_text(std::string_view text, const std::string& path);

}  // namespace stillpoint::records
