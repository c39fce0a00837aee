// SPDX-License-Identifier: MIT
#pragma once

#include "../checkpoint.hpp"
#include "../descriptor.hpp"

#include <stillpoint/sweep/sink.hpp>

#include <memory>
#include <optional>
#include <string>

namespace stillpoint::sweep {

/// Empty if there is no such file. Throws FileError if it is not a checkpoint.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::string& path);

/// The files of a sweep that is not complete: FILE.part has its rows, and FILE.part.json, the
/// checkpoint, says how many bytes of that are whole rows.
struct OpenPart {
  std::string target;     ///< FILE, behind its links
  Descriptor descriptor;  ///< of FILE.part, locked, at its end
  Checkpoint saved;       ///< what FILE.part.json says

  [[nodiscard]] std::string part() const { return target + ".part"; }
  [[nodiscard]] std::string checkpoint() const { return part() + ".json"; }
  /// Replaces the checkpoint by `saved`, in one step: the old or the new one is there whenever the
  /// program ends. Throws FileError.
  void save() const;
};

/// Makes the files ready for the rows that are still to come, and throws as open_rows does. To
/// resume where nothing is left is to begin.
[[nodiscard]] OpenPart open_part(PartLabel label, bool resume);

/// The file that parts of a sweep are joined into, or a device or a pipe. Nothing that an
/// interrupted merge with the same task left is kept.
[[nodiscard]] std::unique_ptr<RowSink> open_whole(const std::string& output,
                                                  const std::string& task);

/// A file that appears under its name when it is complete, and grows as FILE.part until then. The
/// rows are on the disk before the checkpoint says so, and the checkpoint is replaced in one step:
/// whenever the program or the machine ends, the sweep can be resumed.
class PartFile : public RowSink {
 public:
  explicit PartFile(OpenPart files);

  void write(std::string_view bytes) override;
  void reached(const SweepState& state) override;
  void finish(std::string_view header) override;
  LeftRows leave() override;

 private:
  void save();
  void synchronize();

  OpenPart files_;
  SweepState state_;  ///< what is written
  double next_save_s_;
};

}  // namespace stillpoint::sweep
