// SPDX-License-Identifier: MIT
#include <stillpoint/report/findings.hpp>
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace stillpoint::report {

namespace {

using design::Finding;
using design::FindingKind;
using design::FindingValue;
using design::Severity;
using nlohmann::ordered_json;

/// With values {name} or {name:form}. Of [one|other] stands the first of which all values exist, if
/// any. {name?} has no words and exists if the value does, {name=other?} if it is that text or has
/// the value of that name.
struct Wording {
  FindingKind kind;
  std::string_view pattern;
};
constexpr auto wordings = [] {
  using enum FindingKind;
  return std::to_array<Wording>({
      {acts_late,
       "The notch is assumed to act only after the start; [one {width} wide, which acts "
       "throughout, stops the mass too|design --notch-width[{physical?}-m] shows what a real one "
       "does]."},
      {catches_hit,
       "The notch catches the hit, as it does any below {least_velocity}: the structure feels it "
       "in full, {caught_impulse} times the mass."},
      {catches_weak_hits,
       "The notch catches [every hit below {least_velocity}|all hits of the range], which the "
       "structure feels in full: up to {caught_impulse} times the mass."},
      {check_failed,
       "The independent check disagrees by {relative_error:.1e} where {tolerance:.0e} is allowed: "
       "do not rely on this design."},
      {close_call,
       "[If all inputs shift by {decision_margin:%}, that|Rounding] could change {changes}."},
      {delta_unbounded,
       "Nothing bounds delta: anything above {least_delta} stops the mass, and more only adds "
       "tolerance. --delta-max[{physical?}-m] gives a smaller notch, for example {proposed}."},
      {does_not_isolate,
       "The structure feels {peak_absolute_acceleration}, more than 95 % of the load of "
       "{largest_load}: this damper isolates nothing.[{asked?} Nothing asked for less: give "
       "--acceleration-max, or --objective acceleration.]"},
      {ends_before_load, "The run ends after {end_time} of the {load_end} of the load."},
      {exact_only,
       "Only exactly this damper was tried; one that is slightly off may behave quite differently. "
       "--tolerance 10% tries those too."},
      {exceeds_later, "After the first swing, which meets its limit, the {figure} is {beyond}."},
      {fails_if_off,
       "If [{input=period?}the period|{input=load?}the load|the scale of all records] is off by "
       "{off:%}[{besides?} as well], the [{figure} may be {beyond}|mass may never come to rest]"
       "[{others=1?}, and another limit is exceeded|, and {others} other limits are exceeded]."},
      {felt_in_notch,
       "In the notch the structure feels up to {peak_absolute_acceleration}, outside it "
       "{outside}: --objective acceleration looks for a gentler one."},
      {friction_above_weight,
       "The friction is more than the weight: that takes a brake, not a bearing."},
      {interrupted, "The search was interrupted: a complete one may find a better damper."},
      {jolts,
       "At the notch the velocity jumps by up to {jump}[, at {p:spring}]; the accelerations leave "
       "these jumps out."},
      {least_friction_is_best,
       "The less constant friction, the better[: with any f up to {f:most}, delta may be off by "
       "{tolerance:%}]."},
      {locks,
       "The notch locks the mass until the end of [{of_records=1?}{records?}the "
       "record|{records=of_records?}every record|{records} of {of_records} records|{pulses?}the "
       "load|{periods?}the load at [{periods=of_periods?}every period|{periods} of {of_periods} "
       "periods][{of_records=1?}| under at least one record]|the load, at x = {final_position} "
       "from "
       "{locked_from} to "
       "{load_end}][, after it moves for {moved} in all]; the structure then feels up to "
       "{largest_load_while_locked}."},
      {never_moves,
       "[{damper=exact?}Without any error the|The] mass never moves: [{records=1?}it is held "
       "through the record|{records?}it is held "
       "through every record|{stop_position=0?}nothing acts on it|[{by=notch?}the ]{by} holds it[ "
       "at x = {stop_position}]][, and the structure feels up to {largest_load}]."},
      {no_notch_works,
       "No notch with this delta works: [only one wider than {least_width:least} would let the "
       "load "
       "move the mass, but the peak is {peak_amplitude}|the weakest load does not even overcome "
       "the friction].[ --delta-max[{physical?}-m] gives a smaller one, for example {proposed}.]"},
      {no_width_found,
       "The notch is assumed to act only after the start. Of {widths} that act throughout, "
       "{least_width} to {most_width} wide, none lets the mass out and stops it: try --hold[, or "
       "look for another damper with --search-notch-width-m and --residual-m{physical?}]."},
      {notch_changes_nothing, "With this notch the mass moves as with an ideal one."},
      {notch_fails,
       "[{what=held?}With this notch a pulse of {k} never moves the mass|{what=moving?}With this "
       "notch the mass never comes to rest|{what=inside?}The mass never leaves this notch[, and "
       "rests at x = {value}]|[{what=peak?}With this notch the peak is|{what=rest?}With this notch "
       "the mass rests off centre by|In this notch the structure feels] [{beyond}|{value}][ after "
       "a hit of {v0}[{from?} from inside the notch]| after a pulse of {k}[ and {duration}]][, "
       "with {p:spring}]]"
       "[{what=rest?}{limit?}|{what=rest?}: --residual[{physical?}-m] admits that]."},
      {notch_gains_little, "The notch is left out: it would gain less than one per cent."},
      {notch_needs_width,
       "No notch was searched: without a width nobody knows what the mass feels in it. "
       "--notch-width[{physical?}-m or --search-notch-width-m] gives it one; "
       "--jump-max[{physical?}|-v] admits one without, as of a rocking support."},
      {notch_unused, "The mass never comes back to the notch: delta has no effect on this hit."},
      {peaks_develop,
       "[{trend=settle?}The peaks settle at {last_peak}|{trend=vary?}The last peaks lie between "
       "{least_peak} and {largest_peak}|The peaks {trend}, the last to {last_peak}]."},
      {ranges_estimated, "Durations and periods between those that were tried are estimated."},
      {recentres_weakly,
       "Re-centring is weak without the notch: E_s/E_h is {energy_ratio:.2g}, where EN 15129 asks "
       "for {limit:.2g}."},
      {records_exceed_limit,
       "In {records} of {of_records} records the {figure} exceeds a limit that the mean meets: "
       "under {record} it is {beyond}."},
      {search_cut_short,
       "The search for changes was cut short after a second: another may help as well."},
      {sensitive,
       "[With {varied} 1 % off either way the mass rests between x = {rest_low} and {rest_high}[, "
       "and that may change {changes}]|If {varied} [{varied=f?}is|are] 1 % off, "
       "that may change {changes}]."},
      {too_exact,
       "Too exact to be built: [{tolerance=0?}nothing may be off|the tolerance is only "
       "{tolerance:%}|f is on the edge of the region].[{asked?} --tolerance 5% asks for more.]"},
  });
}();
constexpr bool in_order() {
  for (std::size_t i = 0; i < wordings.size(); ++i) {
    if (wordings.at(i).kind != static_cast<FindingKind>(i)) {
      return false;
    }
  }
  return wordings.size() == static_cast<std::size_t>(FindingKind::too_exact) + 1;
}
static_assert(in_order(), "each kind has a pattern, in their order");

/// What "changes" says.
std::string changed_words(std::string_view what) {
  return what == "start"  ? "whether it starts"
         : what == "stop" ? "the number of half-cycles or whether it stops at x = 0"
         : what == "rest" ? "whether it comes to rest"
                          : "whether it locks";
}

/// A finding and the units to tell it in.
class Told {
 public:
  Told(const Finding& finding, const Physical& physical)
      : values_(finding.values), physical_(physical) {}

  /// A pattern up to the bracket behind it, which is passed over: one of its alternatives.
  [[nodiscard]] std::string choice(std::string_view& pattern) const {
    std::optional<std::string> chosen = filled(pattern);
    while (pattern.starts_with('|')) {
      pattern.remove_prefix(1);
      const auto other = filled(pattern);
      chosen = chosen ? chosen : other;
    }
    pattern.remove_prefix(pattern.empty() ? 0 : 1);
    return chosen.value_or("");
  }

 private:
  [[nodiscard]] std::optional<std::string> filled(std::string_view& pattern) const {
    std::string text;
    bool exist = true;
    while (!pattern.empty() && pattern.front() != '|' && pattern.front() != ']') {
      const char sign = pattern.front();
      pattern.remove_prefix(1);
      if (sign == '{') {
        const std::string_view value = pattern.substr(0, pattern.find('}'));
        pattern.remove_prefix(value.size() + 1);
        const auto words = value.ends_with('?') ? condition(value) : words_of(value);
        exist = exist && words;
        text += words.value_or("");
      } else {
        text += sign == '[' ? choice(pattern) : std::string(1, sign);
      }
    }
    return exist ? std::optional(text) : std::nullopt;
  }

  [[nodiscard]] std::optional<std::string> condition(std::string_view text) const {
    text.remove_suffix(1);
    const std::size_t equals = std::min(text.find('='), text.size());
    const FindingValue* const value = find(text.substr(0, equals));
    const std::string_view other = text.substr(std::min(equals + 1, text.size()));
    const bool holds = text == "physical"                  ? physical_.has_value()
                       : value == nullptr || other.empty() ? value != nullptr
                       : find(other) != nullptr            ? value->value == find(other)->value
                                                           : plain(*value) == other;
    return holds ? std::optional("") : std::nullopt;
  }

  static std::string plain(const FindingValue& of) {
    const auto* const number = std::get_if<double>(&of.value);
    return number != nullptr
               ? digits(*number + 0.0)
               : std::visit([](const auto& value) { return fmt::format("{}", value); }, of.value);
  }

  [[nodiscard]] std::optional<std::string> words_of(std::string_view text) const {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view name = text.substr(0, colon);
    const FindingValue* const limit = find("limit");
    const FindingValue* const value = find(name == "beyond" ? "value" : name);
    if (value == nullptr || (name == "beyond" && limit == nullptr)) {
      return std::nullopt;
    }
    if (std::holds_alternative<std::int64_t>(value->value)) {
      return plain(*value);
    }
    if (const auto* const word = std::get_if<std::string>(&value->value)) {
      return name == "changes"  ? changed_words(*word)
             : name == "record" ? scaled_name(*word, number(*find("scale")))
                                : *word;
    }
    return name == "beyond" ? beyond(physical_, value->dimension, number(*value), number(*limit))
                            : in_form(*value, text.substr(std::min(colon + 1, text.size())));
  }

  /// In that of its dimension if none is given.
  [[nodiscard]] std::string in_form(const FindingValue& of, std::string_view form) const {
    constexpr int few = 3;
    const double value = number(of);
    return form.empty()       ? figure_shown(physical_, of.dimension, value)
           : form == "%"      ? format("{:.2g} %", 100 * value)
           : form == "least"  ? length_limit(physical_, value, true)
           : form == "most"   ? limit_digits(value, false, few)
           : form == "spring" ? period_words(physical_, value)
                              : fmt::format(fmt::runtime(format("{{:{}}}", form)), value);
  }

  static double number(const FindingValue& of) { return std::get<double>(of.value); }
  [[nodiscard]] const FindingValue* find(std::string_view name) const {
    const auto found = std::ranges::find(values_, name, &FindingValue::name);
    return found != values_.end() ? &*found : nullptr;
  }

  std::span<const FindingValue> values_;
  const Physical& physical_;
};

std::string sentence(const Finding& finding, const Physical& physical) {
  std::string_view pattern = wordings.at(static_cast<std::size_t>(finding.kind)).pattern;
  return Told(finding, physical).choice(pattern);
}

/// The findings of that severity; what is the same in several cases is said once.
std::vector<std::string> all_words(std::span<const Finding> findings, Severity severity,
                                   const Physical& physical) {
  struct OfCases {
    std::string cases, sentence;
  };
  std::vector<OfCases> told;
  for (const Finding& now : findings) {
    if (now.severity != severity) {
      continue;
    }
    std::string_view of_case = "{case}";
    const OfCases said{Told(now, physical).choice(of_case), sentence(now, physical)};
    const auto same = std::ranges::find_if(told, [&said](const OfCases& before) {
      return !before.cases.empty() && before.sentence == said.sentence;
    });
    if (same != told.end() && !said.cases.empty()) {
      same->cases += ", " + said.cases;
    } else {
      told.push_back(said);
    }
  }
  std::vector<std::string> all;
  all.reserve(told.size());
  for (const OfCases& each : told) {
    all.push_back(each.cases + (each.cases.empty() ? "" : ": ") + each.sentence);
  }
  return all;
}

}  // namespace

std::string words(const Finding& finding, const Physical& physical) {
  std::string_view of_case = "{case}: ";
  return Told(finding, physical).choice(of_case) + sentence(finding, physical);
}

ordered_json findings_json(std::span<const design::Finding> findings, const Physical& physical) {
  ordered_json list = ordered_json::array();
  for (const design::Finding& finding : findings) {
    ordered_json& now = list.emplace_back(ordered_json{{"kind", name(finding.kind)},
                                                       {"severity", name(finding.severity)},
                                                       {"text", words(finding, physical)}});
    for (const FindingValue& value : finding.values) {
      const std::string key(value.name);
      std::visit([&](const auto& of) { now[key] = of; }, value.value);
      if (const auto suffix = si_suffix(value.dimension); physical && !suffix.empty()) {
        now[key + std::string(suffix)] =
            physical->scales.in_si(value.dimension, std::get<double>(value.value)).value();
      }
    }
  }
  return list;
}

std::string_view advice(std::span<const design::Finding> findings, std::string_view usual) {
  return std::ranges::any_of(findings,
                             [](const design::Finding& now) {
                               return now.severity == Severity::fault ||
                                      now.kind == FindingKind::too_exact;
                             })
             ? "The damper found has"
             : usual;
}

void add_findings(Document& document, std::span<const design::Finding> findings,
                  const Physical& physical) {
  Section before;
  const auto add = [&](Section& to, Severity severity, std::string label, Tone tone) {
    for (std::string& now : all_words(findings, severity, physical)) {
      to.row(std::exchange(label, ""), std::move(now), tone);
      if (severity != Severity::info) {
        document.tone = severity == Severity::fault   ? Tone::bad
                        : document.tone == Tone::good ? Tone::plain
                                                      : document.tone;
      }
    }
  };
  add(before, Severity::fault, "fault", Tone::bad);
  add(before, Severity::caution, "caution", Tone::bad);
  auto& parts = document.answer.parts;
  parts.insert(parts.begin(), before.parts.begin(), before.parts.end());
  add(document.answer, Severity::info, "note", Tone::plain);
}

}  // namespace stillpoint::report
