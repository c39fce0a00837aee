// SPDX-License-Identifier: MIT
#include <stillpoint/report/findings.hpp>
#include "sections.hpp"

#include <stillpoint/texts/embedded.hpp>

namespace stillpoint::report {

namespace {

using design::Finding;
using design::FindingValue;
using design::Severity;
using nlohmann::ordered_json;

/// Values and the units to tell them in.
class Told {
 public:
  Told(std::span<const FindingValue> values, const Physical& physical)
      : values_(values), physical_(physical) {}

  /// A pattern up to the bracket behind it, which is passed over: one of its alternatives.
  [[nodiscard]] std::string choice(std::string_view& pattern) const {
    std::optional<std::string> chosen = alternative(pattern);
    while (pattern.starts_with('|')) {
      pattern.remove_prefix(1);
      const auto other = alternative(pattern);
      chosen = chosen ? chosen : other;
    }
    pattern.remove_prefix(pattern.empty() ? 0 : 1);
    return chosen.value_or("");
  }

 private:
  [[nodiscard]] std::optional<std::string> alternative(std::string_view& pattern) const {
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
      return name == "changes"  ? std::string(texts::line_of("words/changes.txt", *word))
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
  return filled(texts::line_of("words/findings.txt", name(finding.kind)), finding.values, physical);
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
    const OfCases said{filled("{case}", now.values, physical), sentence(now, physical)};
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

std::string filled(std::string_view pattern, std::span<const FindingValue> values,
                   const Physical& physical) {
  return Told(values, physical).choice(pattern);
}

std::string words(const Finding& finding, const Physical& physical) {
  return filled("{case}: ", finding.values, physical) + sentence(finding, physical);
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
                                      now.kind == design::FindingKind::too_exact;
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
