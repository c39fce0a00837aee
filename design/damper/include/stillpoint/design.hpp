// SPDX-License-Identifier: MIT
#pragma once

// All of stillpoint::design; it includes what it uses of stillpoint::core.

#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/physical_input.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/pulse_check.hpp>
#include <stillpoint/design/pulse_design.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/region_answer.hpp>
#include <stillpoint/design/search.hpp>
