// SPDX-License-Identifier: MIT
// A region: which dampers stop the mass on its first return, and whether a given one does.

#include <stillpoint/design.hpp>

#include <iostream>

int main() {
  const stillpoint::design::Problem problem{.v0 = 1, .p = 1, .beta = 0.9};
  const stillpoint::design::Region region = admissible_region(problem);
  if (!region.feasible) {
    std::cout << "no damper works: " << *reason(region, problem) << '\n';
    return 1;
  }
  std::cout << "f      " << region.f_lower.value() << " .. " << region.f_upper.value() << '\n'
            << "delta  at most " << region.delta2.value() << ", at f = 0.26 above "
            << *delta1(problem, 0.26) << "\n\n";

  for (const auto& row : constraints(problem, 0.26, 0.37)) {
    std::cout << row.name << ": " << row.value << ' ' << row.relation << ' ' << row.limit
              << (row.satisfied ? "" : "  FAILS") << '\n';
  }
  if (const auto tolerance = largest_tolerance(problem, {}, 0.26, 0.37)) {
    std::cout << "\nf and delta may both be off by " << 100 * *tolerance << " %\n";
  }
}
