// SPDX-License-Identifier: MIT
#pragma once

// All of stillpoint::design, with what it uses from stillpoint::core and the error it throws.

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/box_shape.hpp>
#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/doubtful_values.hpp>
#include <stillpoint/design/duty.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/practice.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/design/record_findings.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/spectrum.hpp>
#include <stillpoint/design/trade_off.hpp>
#include <stillpoint/design/works_for.hpp>
