// SPDX-License-Identifier: MIT
#include "step.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <algorithm>
#include <cassert>
#include <utility>

namespace stillpoint::sweep {

SweepStep::SweepStep(const SweepSpec& spec, std::stop_token stop)
    : spec_(spec),
      stop_(std::move(stop)),
      times_(std::ranges::find(spec.columns, Quantity::stop_time) != spec.columns.end()),
      from_zero_(from_zero(spec)),
      one_v0_and_p_(!varies(spec, Quantity::v0) && !varies(spec, Quantity::p)) {}

void SweepStep::operator()(SweepBlock& block) {
  switch (spec_.kind) {
    case SweepKind::free:
      return run_free(block);
    case SweepKind::forced:
      return run_forced(block);
    case SweepKind::design:
      return run_design(block);
  }
  assert(false && "a SweepKind outside its enumeration");
}

void SweepStep::for_each(const SweepBlock& block,
                         const std::function<void(Eigen::Index)>& body) const {
  for_each_entry(
      block.size, spec_.threads, [this] { return !stop_.stop_requested(); }, body);
}

}  // namespace stillpoint::sweep
