// SPDX-License-Identifier: MIT
#include <stillpoint/report/findings.hpp>
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

namespace stillpoint::report {

namespace {

using design::FindingKind;
using design::FindingValue;
using design::Severity;
using nlohmann::ordered_json;

/// The values of a finding by their names.
class Told {
 public:
  Told(const design::Finding& finding, const Physical& physical)
      : values_(finding.values), physical_(physical) {}

  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
  [[nodiscard]] double number(std::string_view name) const {
    return std::get<double>(find(name)->value);
  }
  [[nodiscard]] std::int64_t count(std::string_view name) const {
    return std::get<std::int64_t>(find(name)->value);
  }
  [[nodiscard]] const std::string& text(std::string_view name) const {
    return std::get<std::string>(find(name)->value);
  }
  /// With its unit.
  [[nodiscard]] std::string operator[](std::string_view name) const {
    return figure_shown(physical_, find(name)->dimension, number(name));
  }
  /// "412 mm where 400 mm is allowed"
  [[nodiscard]] std::string beyond_limit() const {
    return beyond(physical_, find("value")->dimension, number("value"), number("limit"));
  }
  /// Of a share of 1.
  [[nodiscard]] std::string percent(std::string_view name) const {
    return format("{:.2g} %", 100 * number(name));
  }
  /// "the record", "every record" or "1 of 2 records"
  [[nodiscard]] std::string records(std::string_view counted = "records") const {
    return of_records(static_cast<std::size_t>(count(counted)),
                      static_cast<std::size_t>(count(has("of_records") ? "of_records" : counted)));
  }
  [[nodiscard]] bool is_physical() const { return physical_.has_value(); }

 private:
  [[nodiscard]] const FindingValue* find(std::string_view name) const {
    const auto found = std::ranges::find(values_, name, &FindingValue::name);
    return found != values_.end() ? &*found : nullptr;
  }

  std::span<const FindingValue> values_;
  const Physical& physical_;
};

/// "The notch locks the mass at x = 0 from 2.717 s of 3.5 s on"
std::string lock_words(const Told& told) {
  if (told.has("records")) {
    return format("The notch locks the mass to the end of {}", told.records());
  }
  if (told.has("periods")) {
    const std::int64_t all = told.count("of_periods");
    const std::int64_t locked = told.count("periods");
    return format("The notch locks the mass to the end of {} record{}",
                  told.count("of_records") == 1 ? "the" : "a",
                  all == 1        ? ""
                  : locked == all ? " at every period"
                                  : format(" at {} of {} periods", locked, all));
  }
  return format("The notch locks the mass at x = {} {}", told["final_position"],
                told.number("locked_from") == 0
                    ? "throughout the load"
                    : format("from {} to the end at {}", told["locked_from"], told["load_end"]));
}

std::string rest_words(const Told& told) {
  if (told.has("records")) {
    return format("it is held through {}, and the structure feels up to {}", told.records(),
                  told["largest_load"]);
  }
  if (!told.has("largest_load") && told.has("stop_position") && told.number("stop_position") == 0) {
    return "it starts at rest at x = 0, and nothing acts on it";
  }
  return format("{}{} holds it {}", told.text("by") == "notch" ? "the " : "", told.text("by"),
                told.has("largest_load")
                    ? "throughout the load, and the structure feels up to " + told["largest_load"]
                    : "at x = " + told["stop_position"]);
}

std::string changed_words(const std::string& what) {
  return what == "start"  ? "whether it starts"
         : what == "stop" ? "the number of half-cycles or whether it stops at x = 0"
         : what == "rest" ? "whether it comes to rest"
                          : "whether it locks";
}

std::string peaks_words(const Told& told) {
  const std::string& trend = told.text("trend");
  return trend == "settle" ? format("The peaks settle at {}.", told["last_peak"])
         : trend == "vary" ? format("The last peaks lie between {} and {}.", told["least_peak"],
                                    told["largest_peak"])
                           : format("The peaks {}, the last to {}.", trend, told["last_peak"]);
}

/// Of f and Delta slightly off.
std::string sensitive_words(const Told& told, const Physical& physical) {
  const std::string changes = told.has("changes") ? changed_words(told.text("changes")) : "";
  if (!told.has("rest_low")) {
    return format("If {} 1 % off, that may change {}.",
                  told.text("varied") + (told.text("varied") == "f" ? " is" : " are"), changes);
  }
  constexpr int digits = 3;
  return format("With {} 1 % off either way it rests between x = {} and {}{}{}.",
                told.text("varied"), length_shown(physical, told.number("rest_low"), digits),
                length_shown(physical, told.number("rest_high"), digits),
                changes.empty() ? "" : ", and that may change ", changes);
}

/// What the notch that will be built spoils, and after which motion of the ranges.
std::string notch_words(const Told& told, const Physical& physical) {
  const std::string& what = told.text("what");
  if (what == "held") {
    return format("With this notch a pulse of {} never moves the mass.", told["k"]);
  }
  if (what == "moving") {
    return "With this notch the mass never comes to rest.";
  }
  if (what == "inside") {
    return format("The mass never leaves this notch{}.",
                  told.has("value") ? ", and rests at x = " + told["value"] : "");
  }
  std::string motion;
  if (told.has("v0")) {
    motion = format(" after a hit of {}{}", told["v0"],
                    told.has("from") ? " from inside the notch" : "");
  } else if (told.has("k")) {
    motion = format(" after a pulse of {}{}", told["k"],
                    told.has("duration") ? " and " + told["duration"] : "");
  }
  if (told.has("p")) {
    motion += ", with " + period_words(physical, told.number("p"));
  }
  const std::string value = told.has("limit") ? told.beyond_limit() : told["value"];
  return what == "peak" ? format("With this notch the peak is {}{}.", value, motion)
         : what == "rest"
             ? format("With this notch the mass rests off centre by {}{}.", value, motion)
             : format("In this notch the structure feels {}{}.", value, motion);
}

/// As an option takes it: "29mm".
std::string two_digits(const Physical& physical, double length) {
  const double unit = physical ? physical->scales.length_m : 1;
  std::string text = length_shown(physical, records::decimal(length * unit, 2) / unit);
  std::erase(text, ' ');
  return text;
}

/// Of a search whose best has next to no constant friction.
std::string least_friction_words(const Told& told) {
  return format("The less constant friction, the better{}.",
                told.has("f")
                    ? format(": with any f up to {}, delta may be off by {}",
                             limit_digits(told.number("f"), false, 3), told.percent("tolerance"))
                    : "");
}

}  // namespace

std::string words(const design::Finding& finding, const Physical& physical) {
  const Told told(finding, physical);
  switch (finding.kind) {
    case FindingKind::acts_late:
      return format(
          "This is for a notch that acts only after the start; design --notch-width{} shows what a "
          "real one does.",
          told.is_physical() ? "-m" : "");
    case FindingKind::catches_hit:
      return format(
          "The notch catches the hit, as it does any below {}: the structure feels it in full, {}.",
          told["least_velocity"], impulse_shown(physical, told.number("caught_impulse")));
    case FindingKind::catches_weak_hits:
      return format("The notch catches {}, which the structure feels in full: up to {}.",
                    told.has("least_velocity") ? "every hit below " + told["least_velocity"]
                                               : "all hits of the range",
                    impulse_shown(physical, told.number("caught_impulse")));
    case FindingKind::check_failed:
      return format(
          "The independent check disagrees by {:.1e} where {:.0e} is allowed: do not rely on this "
          "design.",
          told.number("relative_error"), told.number("tolerance"));
    case FindingKind::close_call:
      return told.has("decision_margin")
                 ? format("If all inputs shift by {}, that could change {}.",
                          told.percent("decision_margin"), changed_words(told.text("changes")))
                 : format("Rounding could change {}.", changed_words(told.text("changes")));
    case FindingKind::delta_unbounded:
      return format(
          "Nothing bounds delta: anything above {} stops the mass, and more only adds tolerance. "
          "--delta-max{} {} gives a smaller notch.",
          length_shown(physical, told.number("least_delta")), told.is_physical() ? "-m" : "",
          two_digits(physical, told.number("proposed")));
    case FindingKind::does_not_isolate:
      return format(
          "The structure feels {}, more than 95 % of the load of {}: this damper isolates nothing.",
          told["peak_absolute_acceleration"], told["largest_load"]);
    case FindingKind::ends_before_load:
      return format("The run ends after {} of the {} of the load.", told["end_time"],
                    told["load_end"]);
    case FindingKind::exact_only:
      return "No other damper was tried: one that is not exactly this one may do anything.";
    case FindingKind::exceeds_later:
      return format("After the first swing, which meets its limit, the {} is {}.",
                    told.text("figure"), told.beyond_limit());
    case FindingKind::fails_if_off:
      return format(
          "If {} off by {} as well, {}.",
          told.text("input") == "period" ? "the period is" : "the scale of all records is",
          told.percent("off"),
          told.has("value") ? format("the {} may be {}", told.text("figure"), told.beyond_limit())
                            : "the mass may never come to rest");
    case FindingKind::friction_above_weight:
      return "The friction is more than the weight: that takes a brake, not a bearing.";
    case FindingKind::interrupted:
      return "The search was interrupted: a complete one may find a better damper.";
    case FindingKind::jolts:
      return format(
          "At the notch the velocity jumps by up to {}{}; the accelerations leave these jumps out.",
          told["jump"], told.has("p") ? ", at " + period_words(physical, told.number("p")) : "");
    case FindingKind::least_friction_is_best:
      return least_friction_words(told);
    case FindingKind::locks:
      return format(
          "{}{}; the structure then feels up to {}.", lock_words(told),
          told.has("moved") ? format(", after it moves for {} in all", told["moved"]) : "",
          told["largest_load_while_locked"]);
    case FindingKind::never_moves:
      return format("The mass never moves: {}.", rest_words(told));
    case FindingKind::no_notch_works:
      return format(
          "No notch works: only one wider than {} would let the load move the mass, but the peak "
          "is "
          "{}.",
          length_limit(physical, told.number("least_width"), true), told["peak_amplitude"]);
    case FindingKind::notch_changes_nothing:
      return "With this notch the mass moves as with the paper's.";
    case FindingKind::notch_fails:
      return notch_words(told, physical);
    case FindingKind::notch_gains_little:
      return "The notch is left out: it would gain less than one per cent.";
    case FindingKind::notch_needs_width:
      return format(
          "No notch was searched: without a width nobody knows what the mass feels in it. {} gives "
          "it one; {} admits one without, as of a rocking support.",
          told.is_physical() ? "--notch-width-m or --search-notch-width-m" : "--notch-width",
          told.is_physical() ? "--jump-max" : "--jump-max-v");
    case FindingKind::notch_unused:
      return "The mass never comes back to the notch: delta has no effect on this hit.";
    case FindingKind::peaks_develop:
      return peaks_words(told);
    case FindingKind::ranges_estimated:
      return "Durations and periods between those that were tried are estimated.";
    case FindingKind::recentres_weakly:
      return format(
          "Re-centring is weak without the notch: E_s/E_h is {:.2g}, where EN 15129 asks for "
          "{:.2g}.",
          told.number("energy_ratio"), told.number("limit"));
    case FindingKind::records_exceed_limit:
      return format("{} exceed{} a limit that the mean meets: under {} the {} is {}.",
                    told.records(), told.count("records") == 1 ? "s" : "",
                    scaled_name(told.text("record"), told.number("scale")), told.text("figure"),
                    told.beyond_limit());
    case FindingKind::search_cut_short:
      return "The search for changes was cut short after a second: another may help as well.";
    case FindingKind::sensitive:
      return sensitive_words(told, physical);
    case FindingKind::too_exact:
      return format("Too exact to be built: {}.",
                    !told.has("tolerance") ? "f is on the edge of the region"
                    : leaves_any(told.number("tolerance"))
                        ? "the tolerance is only " + percent_digits(told.number("tolerance"))
                        : "it has no tolerance");
  }
  return {};
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

bool is_useless(std::span<const design::Finding> findings) {
  return std::ranges::any_of(findings, [](const design::Finding& now) {
    return now.severity == Severity::fault || now.kind == FindingKind::too_exact;
  });
}

void add_findings(Document& document, std::span<const design::Finding> findings,
                  const Physical& physical) {
  Section before;
  const auto add = [&](Section& to, Severity severity, std::string label, Tone tone) {
    for (const design::Finding& now : findings) {
      if (now.severity == severity) {
        to.row(std::exchange(label, ""), words(now, physical), tone);
        if (severity != Severity::info) {
          document.tone = severity == Severity::fault   ? Tone::bad
                          : document.tone == Tone::good ? Tone::plain
                                                        : document.tone;
        }
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
