// SPDX-License-Identifier: MIT
#pragma once

// What the tests of the program use.

#include "refusal.hpp"
#include "report_fields.hpp"
#include "sweep_table.hpp"
#include "testing/test.hpp"

namespace stillpoint::cli_test {

using nlohmann::json;
namespace data = boost::unit_test::data;
namespace fs = std::filesystem;

}  // namespace stillpoint::cli_test
