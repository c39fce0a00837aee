// SPDX-License-Identifier: MIT
#include <stillpoint/design/finding.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace stillpoint::design {

namespace {

using enum FindingKind;
using enum Severity;

// Those that are neither are a caution.
constexpr std::array infos{
    acts_late,         catches_weak_hits,      delta_unbounded,       ends_before_load,
    fails_if_off,      least_friction_is_best, notch_changes_nothing, notch_gains_little,
    notch_needs_width, notch_unused,           peaks_develop,         ranges_estimated,
    recentres_weakly,  search_cut_short};
constexpr std::array faults{check_failed, does_not_isolate, no_notch_works, notch_fails};

Severity severity_of(FindingKind kind) {
  const auto is_in = [kind](const auto& some) {
    return std::ranges::find(some, kind) != some.end();
  };
  return is_in(infos) ? info : is_in(faults) ? fault : caution;
}

}  // namespace

Finding::Finding(FindingKind of, std::vector<FindingValue> with)
    : kind(of), severity(severity_of(of)), values(std::move(with)) {}

Finding& Finding::add(std::string_view name, const std::optional<double>& value,
                      records::Dimension dimension) {
  if (value) {
    values.push_back({name, *value, dimension});
  }
  return *this;
}

Finding& Finding::tell(std::string_view name, std::string_view text) {
  values.push_back({name, std::string(text)});
  return *this;
}

Finding& Finding::count(std::string_view name, std::size_t number) {
  values.push_back({name, static_cast<std::int64_t>(number)});
  return *this;
}

}  // namespace stillpoint::design
