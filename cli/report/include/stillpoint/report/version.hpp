// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace stillpoint::report {

[[nodiscard]] std::string program_version();  ///< "0.1.0"
[[nodiscard]] std::string version_line();     ///< program, NLopt, build type, compiler

}  // namespace stillpoint::report
