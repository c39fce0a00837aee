// SPDX-License-Identifier: MIT
#pragma once

#include "../descriptor.hpp"

#include <stillpoint/sweep/sink.hpp>

#include <memory>
#include <optional>
#include <string>

namespace stillpoint::sweep {

/// The contents of the file beside FILE.part.
struct Checkpoint {
  std::string task;  ///< SweepSpec::identity
  SweepState state;
  std::int64_t bytes{0};  ///< of the header and whole rows
  bool complete{false};   ///< only the name of the file is missing
};

/// Throws InputError unless the identity of a sweep is a JSON object.
void require_task(const std::string& task);

/// Empty if there is no such file. Throws LeftoverError if it is not a checkpoint.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::string& path);

/// Replaces the file in one step, so the old or the new one is there whenever the program ends. 0
/// or the error.
[[nodiscard]] int write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// The first difference of two tasks, "f was 0:1:10, is 0:1:20"; empty if they are the same.
[[nodiscard]] std::string difference(const std::string& old_task, const std::string& new_task);

/// The files of a sweep that is not complete: FILE.part has its rows, and FILE.part.json, the
/// checkpoint, says how many bytes of that are whole rows.
struct OpenPart {
  std::string target;     ///< FILE, behind its links
  Descriptor descriptor;  ///< of FILE.part, locked, at its end; not open if there is none
  Checkpoint saved;       ///< what FILE.part.json says

  [[nodiscard]] std::string part() const { return target + ".part"; }
  [[nodiscard]] std::string checkpoint() const { return part() + ".json"; }
};

/// Both make the files ready for the rows that are still to come, and throw as open_rows does.
/// `task` is the identity of the sweep.
[[nodiscard]] OpenPart begin_part(const std::string& path, std::string task);
/// Starts from the beginning if there is nothing to resume.
[[nodiscard]] OpenPart resume_part(const std::string& path, std::string task);

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
  void finish(const SweepState& state, std::string_view header) override;
  LeftRows leave() override;

 private:
  void save();
  void synchronize();

  OpenPart files_;
  SweepState state_;  ///< what is written
  std::int64_t bytes_;
  double next_save_s_;
};

}  // namespace stillpoint::sweep
