// SPDX-License-Identifier: MIT
#pragma once

#include "accuracy.hpp"
#include "page.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace stillpoint::cli {

[[nodiscard]] nlohmann::ordered_json accuracy_json(const SimulateInput& input,
                                                   const AccuracyAnswer& answer);
[[nodiscard]] std::string accuracy_text(const SimulateInput& input, const AccuracyAnswer& answer,
                                        const std::optional<std::string>& title, Style style);

}  // namespace stillpoint::cli
