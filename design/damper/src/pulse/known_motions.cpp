// SPDX-License-Identifier: MIT
#include "pulse/known_motions.hpp"

#include <algorithm>

namespace stillpoint::design {

const FirstReturn& KnownMotions::at(double f) {
  const auto place = std::ranges::lower_bound(motions_, f, {}, &FirstReturn::f);
  return place != motions_.end() && place->f == f ? *place
                                                  : *motions_.insert(place, profile_.found_at(f));
}

double KnownMotions::need_between(double low, double high, Criterion criterion) {
  const double most =
      std::max(at(low).need(criterion), profile_.need_of_samples(low, high, criterion));
  return profile_.most_need(high, criterion) <= most ? most
                                                     : std::max(most, at(high).need(criterion));
}

double KnownMotions::need_slope(double f, Criterion criterion) {
  if (profile_.is_single()) {
    return at(f).slope(criterion);
  }
  constexpr double aside = 1e-7;
  const double need = at(f).need(criterion);
  return (need - at(f * (1 - aside)).need(criterion)) / (f * aside);
}

std::vector<FirstReturn> KnownMotions::between(double low, double high) {
  (void)at(low);
  (void)at(high);
  return {std::ranges::lower_bound(motions_, low, {}, &FirstReturn::f),
          std::ranges::upper_bound(motions_, high, {}, &FirstReturn::f)};
}

}  // namespace stillpoint::design
