// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::records {

enum class Rounding { nearest, up, down };

/// The number that `value` is when it is written with so many significant digits, as a reader of
/// these digits has it: the nearest, or the nearest that is not below or not above it. Printed with
/// as many digits it is exact. The value itself where a double holds no such number.
[[nodiscard]] double decimal(double value, int digits, Rounding rounding = Rounding::nearest);

}  // namespace stillpoint::records
