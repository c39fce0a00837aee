// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/quantity.hpp>

#include <algorithm>
#include <string>

namespace stillpoint::sweep {

std::optional<Quantity> find_quantity(std::string_view name) {
  std::string wanted(name);
  std::ranges::replace(wanted, '-', '_');
  const auto* const found = std::ranges::find(quantity_forms, wanted, &QuantityForm::name);
  return found == quantity_forms.end() ? std::nullopt : std::optional(found->quantity);
}

}  // namespace stillpoint::sweep
