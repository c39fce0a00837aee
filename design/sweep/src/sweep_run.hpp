// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_block.hpp"
#include "sweep_task.hpp"

#include <stillpoint/core/batch.hpp>

namespace stillpoint::cli {

/// Finds what a sweep asks for, block by block.
class SweepRun {
 public:
  explicit SweepRun(const SweepTask& task) : task_(task) {}

  /// From the inputs of a block its results. Where Progress has seen an interrupt they may be
  /// incomplete. Throws EntryError for the first entry that is refused.
  void operator()(SweepBlock& block);

 private:
  void run_free(SweepBlock& block);
  void run_free_one_by_one(SweepBlock& block) const;
  void run_forced(SweepBlock& block) const;
  void run_design(SweepBlock& block) const;

  const SweepTask& task_;
  BatchResult batch_;
};

}  // namespace stillpoint::cli
