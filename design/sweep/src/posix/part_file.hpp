// SPDX-License-Identifier: MIT
#pragma once

#include "../descriptor.hpp"

#include <stillpoint/sweep/checkpoint.hpp>
#include <stillpoint/sweep/sink.hpp>

#include <memory>
#include <optional>
#include <string>

namespace stillpoint::sweep {

/// Empty if there is no such file. Throws FileError if it is not a checkpoint.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::string& path);

/// The file that parts of a sweep are joined into, or a device or a pipe. Nothing that an
/// interrupted merge with the same task left is kept.
[[nodiscard]] std::unique_ptr<RowSink> open_whole(const std::string& output,
                                                  const std::string& task);

/// A file that appears under its name when it is complete. Until then FILE.part has its rows, and
/// FILE.part.json, the checkpoint, says how many bytes of that are whole rows. The rows are on the
/// disk before the checkpoint says so, and the checkpoint is replaced in one step: whenever the
/// program or the machine ends, the sweep can be resumed.
class PartFile : public RowSink {
 public:
  /// Of a sweep that begins, ready for the rows that are still to come; throws as open_rows does.
  /// To resume where nothing is left is to begin.
  PartFile(Checkpoint sweep, bool resume);

  void write(std::string_view bytes) override;
  void reached(const SweepState& state) override;
  void finish(std::string_view header) override;
  LeftRows leave() override;

 private:
  [[nodiscard]] bool open_existing();
  void lock() const;
  void create();
  void resume();
  void cut_back(bool checkpoint_exists);
  void save();
  void save_checkpoint() const;
  void synchronize() const;

  std::string target_;  ///< FILE, behind its links
  std::string part_;
  std::string checkpoint_;
  Descriptor descriptor_;  ///< of FILE.part, locked, at its end
  Checkpoint saved_;       ///< what FILE.part.json says
  SweepState state_;       ///< what is written
  double next_save_s_{0};
};

}  // namespace stillpoint::sweep
