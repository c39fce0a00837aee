// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/record_file.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stillpoint::records {

/// Reads a record file line by line, with the numbers in the lines and the errors that name them.
/// Lines end with LF, CR LF, CR CR LF or CR; a byte order mark at the beginning is left out. A copy
/// reads ahead.
class RecordReader {
 public:
  /// All three must outlive this. Throws FileError if the text is empty or binary.
  RecordReader(std::string_view text, const std::string& path, const RecordOptions& options);

  /// Goes to the next line. After the last line it stays there and returns false.
  bool next();

  [[nodiscard]] std::string_view line() const { return line_; }
  /// Counted from 1; 0 before the first `next`.
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }
  [[nodiscard]] const std::string& path() const { return *path_; }
  [[nodiscard]] const RecordOptions& options() const { return *options_; }

  /// Each throws FileError: for this line, for the place of `word` in it, for line `number`.
  [[noreturn]] void refuse(std::string_view message) const { refuse(number_, message); }
  [[noreturn]] void refuse_word(std::string_view word, std::string_view message) const;
  [[noreturn]] void refuse_number(std::string_view word, NumberFault fault) const;
  [[noreturn]] void refuse(std::size_t number, std::string_view message) const;
  /// If the options have a step, for a file that has its own: `line` is where, `what` is which.
  void refuse_step(std::size_t line, std::string_view what) const;
  /// The step in tau that line `line` gives as `name`, in s. Refuses it beside a step of the
  /// options, and one that no motion can follow.
  [[nodiscard]] double file_step(std::size_t line, std::string_view name, double step) const;

  /// The number that `word`, a part of this line, stands for. Refuses anything else.
  [[nodiscard]] double parse_number(std::string_view word) const;

  /// Sets the units of the accelerations from here on.
  void set_units(RecordUnits units);
  /// The same if line `line` of the file gives them. Refuses different ones in the options.
  void set_units(RecordUnits units, std::size_t line);
  /// The acceleration in g that `word` stands for, scaled. In g with the scale 1 no bit changes.
  [[nodiscard]] double parse_acceleration(std::string_view word) const;
  /// In g and scaled; empty if no motion can follow it.
  [[nodiscard]] std::optional<double> in_g(double given) const;
  /// "is out of range", with the bounds.
  [[nodiscard]] std::string load_bounds() const;

 private:
  const std::string* path_;
  const RecordOptions* options_;
  double units_per_g_{1};
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_{0};
};

/// The bound of a step, for messages.
[[nodiscard]] std::string step_bounds(const RecordClock& clock);

/// A format of record files: one source file defines it, one row in record_formats.cpp lists it.
struct RecordFormat {
  std::string_view name;     ///< in the help
  std::string_view endings;  ///< of its files, in upper case, blanks between
  bool (*recognises)(RecordReader reader){nullptr};  ///< may read ahead in its copy
  RecordFile (*read)(RecordReader& reader){nullptr};
  bool has_channels{false};  ///< so that a file may hold several records
};

/// The longest description of a record; the rest is cut off.
inline constexpr std::size_t longest_description = 200;

/// All of them in the order of the help, the columns last.
[[nodiscard]] std::span<const RecordFormat* const> record_formats();

/// What a file is, "is a SAC file, ...", if it has a format that is known but not read; else "".
[[nodiscard]] std::string_view unread_format(std::string_view bytes);

extern const RecordFormat at2_format;
extern const RecordFormat esm_format;
extern const RecordFormat knet_format;
extern const RecordFormat csmip_format;
extern const RecordFormat cosmos_format;
extern const RecordFormat smc_format;
extern const RecordFormat geonet_format;
extern const RecordFormat nsmn_format;
extern const RecordFormat cwb_format;
extern const RecordFormat asa_format;
extern const RecordFormat columns_format;

}  // namespace stillpoint::records
