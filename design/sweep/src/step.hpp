// SPDX-License-Identifier: MIT
#pragma once

#include "block.hpp"
#include "request_of.hpp"

#include <stillpoint/sweep/spec.hpp>

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/forced_motion.hpp>

#include <functional>
#include <stop_token>

namespace stillpoint::sweep {

/// The step of a sweep: from the inputs of a block of entries to their results. There is one branch
/// for each kind of sweep.
class SweepStep {
 public:
  SweepStep(const SweepSpec& spec, std::stop_token stop);

  /// After a stop the results may be incomplete. Throws EntryError for the first entry that is
  /// refused.
  void operator()(SweepBlock& block);

 private:
  void require_ranges(const SweepBlock& block) const;
  void run(SweepBlock& block);
  void run_physical(SweepBlock& block);
  void run_in_batches(SweepBlock& block);
  void run_one_by_one(SweepBlock& block) const;
  void run_design(SweepBlock& block) const;
  void for_each(const SweepBlock& block, const std::function<void(Eigen::Index)>& body) const;
  void for_each_motion(SweepBlock& block, const std::function<void(Eigen::Index)>& body) const;

  const SweepSpec& spec_;
  std::stop_token stop_;
  bool times_;
  bool acceleration_;
  bool in_batches_;  ///< from x = 0, with the paper's friction and notch
  bool one_v0_and_p_;
  BatchResult batch_;
  SweepBlock plain_;  ///< the block without its units
};

}  // namespace stillpoint::sweep
