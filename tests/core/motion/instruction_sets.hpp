// SPDX-License-Identifier: MIT
#pragma once

#include <boost/test/unit_test.hpp>

#include <hwy/targets.h>

#include <cstdint>

namespace stillpoint::test {

/// Calls `action` with each instruction set that this machine has.
template <class Action>
void with_each_instruction_set(const Action& action) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    BOOST_TEST_CONTEXT("instruction set " << hwy::TargetName(target)) {
      action();
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace stillpoint::test
