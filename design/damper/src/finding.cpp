// SPDX-License-Identifier: MIT
#include <stillpoint/design/finding.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace stillpoint::design {

namespace {

using enum FindingKind;
using enum Severity;

struct Form {
  FindingKind kind;
  std::string_view name;
  Severity severity;
};
constexpr auto forms = std::to_array<Form>({
    {acts_late, "acts_late", info},
    {catches_hit, "catches_hit", caution},
    {catches_weak_hits, "catches_weak_hits", info},
    {check_failed, "check_failed", fault},
    {close_call, "close_call", caution},
    {delta_unbounded, "delta_unbounded", info},
    {does_not_isolate, "does_not_isolate", fault},
    {ends_before_load, "ends_before_load", info},
    {exact_only, "exact_only", caution},
    {exceeds_later, "exceeds_later", caution},
    {fails_if_off, "fails_if_off", info},
    {felt_in_notch, "felt_in_notch", caution},
    {friction_above_weight, "friction_above_weight", caution},
    {interrupted, "interrupted", caution},
    {jolts, "jolts", caution},
    {least_friction_is_best, "least_friction_is_best", info},
    {locks, "locks", caution},
    {never_moves, "never_moves", caution},
    {no_notch_works, "no_notch_works", fault},
    {no_width_found, "no_width_found", caution},
    {notch_changes_nothing, "notch_changes_nothing", info},
    {notch_fails, "notch_fails", fault},
    {notch_gains_little, "notch_gains_little", info},
    {notch_needs_width, "notch_needs_width", info},
    {notch_unused, "notch_unused", info},
    {peaks_develop, "peaks_develop", info},
    {ranges_estimated, "ranges_estimated", info},
    {recentres_weakly, "recentres_weakly", info},
    {records_exceed_limit, "records_exceed_limit", caution},
    {search_cut_short, "search_cut_short", info},
    {sensitive, "sensitive", caution},
    {too_exact, "too_exact", caution},
});

}  // namespace

std::span<const Named<Severity>> enumerators(Severity) noexcept {
  static constexpr auto rows =
      std::to_array<Named<Severity>>({{info, "info"}, {caution, "caution"}, {fault, "fault"}});
  return rows;
}

std::span<const Named<FindingKind>> enumerators(FindingKind) noexcept {
  static constexpr auto rows = [] {
    std::array<Named<FindingKind>, forms.size()> names;
    std::ranges::transform(forms, names.begin(), [](const Form& form) {
      return Named<FindingKind>(form.kind, form.name);
    });
    return names;
  }();
  return rows;
}

Finding::Finding(FindingKind of, std::vector<FindingValue> with)
    : kind(of),
      severity(std::ranges::find(forms, of, &Form::kind)->severity),
      values(std::move(with)) {}

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

}  // namespace stillpoint::design
