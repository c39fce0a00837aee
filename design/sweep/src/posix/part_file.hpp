// SPDX-License-Identifier: MIT
#pragma once

#include "open_part.hpp"

#include <stillpoint/sweep/sink.hpp>

namespace stillpoint::sweep {

/// A file that appears under its name when it is complete, and grows as FILE.part until then. The
/// rows are on the disk before the checkpoint says so, and the checkpoint is replaced in one step:
/// whenever the program or the machine ends, the sweep can be resumed.
class PartFile : public RowSink {
 public:
  explicit PartFile(OpenPart files);

  [[nodiscard]] const SweepState& found() const override { return found_; }
  [[nodiscard]] bool complete() const override { return files_.saved.complete; }
  void write(std::string_view bytes) override;
  void reached(const SweepState& state) override;
  void finish(const SweepState& state, std::string_view header) override;
  LeftRows leave() override;

 private:
  void save();
  void synchronize();

  OpenPart files_;
  SweepState found_;
  SweepState state_;  ///< what is written
  std::int64_t bytes_;
  double next_save_s_;
};

}  // namespace stillpoint::sweep
