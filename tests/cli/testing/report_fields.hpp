// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

#include <initializer_list>

namespace stillpoint::cli_test {

/// Asserts that these fields of `object` are near these values.
void check_near(const nlohmann::json& object,
                std::initializer_list<std::pair<const char*, double>> values, double tolerance);

/// The first motion of a design or a given damper: what it is, its response, and that in SI units.
[[nodiscard]] const nlohmann::json& motion_of(const nlohmann::json& report);

/// Asserts that no word of a report is "nan" or "inf".
void check_only_finite(std::string_view report);

/// The report without its wall times, which are the only thing that differs from run to run.
[[nodiscard]] nlohmann::json without_wall_times(nlohmann::json report);

/// |a - b| <= tolerance * max(|a|, |b|)
[[nodiscard]] bool near(double a, double b, double tolerance);

/// 0.4 g at 0 s, -0.2 g at 1 s, 0 at 2 s.
inline constexpr const char* small_record = "0 0.4\n1 -0.2\n2 0\n";

/// With that in a.txt.
struct Recorded : Sandbox {
  Recorded() { write("a.txt", small_record); }
};

}  // namespace stillpoint::cli_test
