// SPDX-License-Identifier: MIT
#pragma once

#include "checkpoint.hpp"
#include "row_sink.hpp"

#include <string>

namespace stillpoint::cli {

/// A file that appears under its name when it is whole, and until then grows as FILE.part. Beside
/// it FILE.part.json says how many of its bytes are whole rows. The rows are on the disk before it
/// says so, and it is replaced in one step: whenever the program or the machine ends, a sweep can
/// go on from there.
class PartFile : public RowSink {
 public:
  /// Throws UsageError, see open_rows.
  PartFile(const std::string& path, std::string task, bool resume);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile(PartFile&&) = delete;
  PartFile& operator=(PartFile&&) = delete;
  ~PartFile() override;

  [[nodiscard]] const SweepState& found() const override { return found_; }
  [[nodiscard]] bool complete() const override { return saved_.complete; }
  void write(std::string_view bytes) override;
  void reached(const SweepState& state) override;
  void finish(const SweepState& state, std::string_view header) override;
  [[nodiscard]] std::string leave() override;

 private:
  void open_new();
  void open_left();
  void cut_back(bool checkpoint_is_there);
  void lock();
  [[nodiscard]] bool open_part();
  void save();
  void synchronize();
  [[noreturn]] void refuse(int error);
  [[nodiscard]] std::string part() const { return target_ + ".part"; }
  [[nodiscard]] std::string checkpoint() const { return part() + ".json"; }

  std::string target_;
  int descriptor_{-1};
  Checkpoint saved_;  ///< what FILE.part.json says
  SweepState found_;
  SweepState state_;  ///< what is written
  std::int64_t bytes_{0};
  double next_save_s_{0};
};

}  // namespace stillpoint::cli
