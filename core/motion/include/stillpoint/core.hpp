// SPDX-License-Identifier: MIT
#pragma once

// All of stillpoint::core.

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/nearby_ends.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/record_batch.hpp>
#include <stillpoint/core/seconds.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/core/traced_state.hpp>
#include <stillpoint/core/trajectory.hpp>
