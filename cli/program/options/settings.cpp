// SPDX-License-Identifier: MIT
#include "options/settings.hpp"

#include <stillpoint/design/doubtful_values.hpp>
#include <stillpoint/design/physical.hpp>

#include <nlohmann/json.hpp>

namespace stillpoint::cli {

namespace {

/// "; with a unit give --period or --stiffness", for an option that has such rivals.
std::string with_a_unit(const Option& option) {
  std::string found;
  for (const Option* other : physical_rivals(option)) {
    found += fmt::format("{}--{}", found.empty() ? "; with a unit give " : " or ", other->name);
  }
  return found;
}

/// Whether it is a force or an energy, to be divided by the weight.
bool is_per_weight(const Option& option, std::string_view number) {
  const Dimension dimension = option.traits.or_per_weight.dimension;
  return dimension != Dimension::none && records::has_unit(number, dimension);
}

/// How many numbers were read and are not 0, and how many of them are over the weight.
struct Read {
  int numbers{0};
  int per_weight{0};
};

/// Of the numbers in this text.
sweep::NumberReader reader(const Option& option, std::string_view text, Read& count) {
  return [&option, text, &count](std::string_view number) {
    const double value = parse_value(option, number);
    count.numbers += value != 0 ? 1 : 0;
    count.per_weight += value != 0 && is_per_weight(option, number) ? 1 : 0;
    if (count.per_weight != 0 && count.per_weight != count.numbers) {
      const bool force = option.traits.or_per_weight.dimension == Dimension::force;
      throw InputError(
          std::string(option.name), std::string(text),
          fmt::format("must have units of {} throughout, or nowhere", force ? "force" : "energy"));
    }
    return value;
  };
}

std::int64_t integer_value(const Option& option, std::string_view text) {
  const Bounds& bounds = option.traits.bounds;
  const auto value = records::scan_integer(text);
  if (value && bounds.least <= *value && *value <= bounds.most) {
    return *value;
  }
  const bool is_number = records::scan_number(text).fault == records::NumberFault::none;
  throw InputError(std::string(option.name),
                   value       ? fmt::format("{}", *value)
                   : is_number ? std::string(text)
                               : records::quoted(text),
                   fmt::format("must be {}", whole_number(option)));
}

double least(const Settings::Value& value) {
  const Axis* const axis = std::get_if<Axis>(&value);
  const Interval* const range = std::get_if<Interval>(&value);
  return axis != nullptr    ? axis->ends().low
         : range != nullptr ? range->low
                            : std::get<double>(value);
}

Settings::Value over(double divisor, const Settings::Value& value) {
  if (const Axis* const axis = std::get_if<Axis>(&value)) {
    return axis->over(divisor);
  }
  if (const Interval* const range = std::get_if<Interval>(&value)) {
    return Interval{range->low / divisor, range->high / divisor};
  }
  return std::get<double>(value) / divisor;
}

/// As it was given, in the SI unit where that was without one.
std::string weighed_text(const Settings::Entry& entry, Dimension dimension) {
  const Axis* const axis = std::get_if<Axis>(&entry.value);
  return entry.with_unit
             ? *entry.with_unit
             : fmt::format("{} {}",
                           axis != nullptr ? axis->text() : fmt::format("{}", least(entry.value)),
                           records::units_of(dimension).front().name);
}

}  // namespace

double parse_value(const Option& option, std::string_view text) {
  if (text.find(':') != std::string_view::npos) {
    throw InputError(std::string(option.name), records::quoted(text),
                     "must be one number, not a range, which only some options of design, region "
                     "and sweep take");
  }
  const Dimension other = option.traits.or_per_weight.dimension;
  const Dimension dimension = is_per_weight(option, text) ? other : option.traits.dimension;
  return records::parse_value(
      option.name, dimension, text,
      other != Dimension::none
          ? fmt::format(", or {} in {}", other == Dimension::force ? "a force" : "an energy",
                        records::unit_names(other))
      : dimension == Dimension::none ? with_a_unit(option)
                                     : "");
}

std::string whole_number(const Option& option) {
  const auto [least, most] = option.traits.bounds;
  return fmt::format("a whole number from {} to {}", least, most);
}

std::optional<double> Settings::number(std::string_view name) const {
  if (const auto both = range(name)) {
    return find_option(name)->traits.range == RangeEnd::low ? both->low : both->high;
  }
  if (const Axis* const axis = find<Axis>(name)) {
    if (!axis->is_number()) {
      throw InputError(std::string(name), axis->text(), "must be one number in a sweep of motions");
    }
    return (*axis)[0];
  }
  return get<double>(name);
}

std::vector<std::string> Settings::texts(std::string_view name) const {
  const std::string joined = text(name).value_or("");
  const auto lines = records::split(joined, '\n');
  return has(name) ? std::vector<std::string>(lines.begin(), lines.end())
                   : std::vector<std::string>();
}

std::optional<std::string> Settings::known(std::string_view name) const {
  auto wanted = text(name);
  const auto values = find_option(name)->values();
  if (wanted && std::ranges::find(values, *wanted) == values.end()) {
    throw InputError(std::string(name), *wanted, must_be(*wanted, values));
  }
  return wanted;
}

void Settings::set_text(const Option& option, const std::string& text, Command command) {
  if (text.find('\0') != std::string::npos) {
    throw InputError(std::string(option.name), records::quoted(text), "must not contain a NUL");
  }
  const bool takes_range = option.takes_range_in(command);
  const bool is_axis = option.kind_in(command) == OptionKind::axis;
  Read count;
  switch (option.kind_in(command)) {
    case OptionKind::axis:
    case OptionKind::number: {
      const auto read = reader(option, text, count);
      const std::size_t colon = takes_range ? text.find(':') : std::string::npos;
      const bool is_range = colon != std::string::npos;
      Entry entry{is_axis
                      ? Value(sweep::parse_axis(option.name, text, read,
                                                takes_range ? option.traits.range : RangeEnd::none))
                  : is_range ? Value(sweep::parse_range(option.name, text, read))
                             : Value(read(text))};
      entry.per_weight = count.per_weight != 0;
      if (!is_axis &&
          (has_unit(text.substr(0, colon)) || (is_range && has_unit(text.substr(colon + 1))))) {
        entry.with_unit = text;
      }
      entries_[option.name] = std::move(entry);
      return;
    }
    case OptionKind::integer:
      return set(option, integer_value(option, text));
    case OptionKind::text:
    case OptionKind::flag:
      break;
  }
  set(option, text);
}

std::optional<records::FilePlace> Settings::place_of(std::string_view field) const {
  // "friction-zones 2: f" belongs to friction-zones.
  std::string wanted = records::hyphened(field.substr(0, field.find_first_of("[ ")));
  for (const std::string_view end : {"-low", "-high"}) {
    if (wanted.ends_with(end)) {
      wanted.resize(wanted.size() - end.size());
    }
  }
  const Option* const option = find_option(wanted);
  if (option == nullptr) {
    return std::nullopt;
  }
  std::vector<const Option*> meant = physical_rivals(*option);
  meant.insert(meant.begin(), option);
  for (const Option* one : meant) {
    if (const auto found = entries_.find(one->name);
        found != entries_.end() && found->second.place) {
      return found->second.place;
    }
  }
  return std::nullopt;
}

InputError Settings::as_given(const InputError& error) const {
  const Option* const plain = find_option(records::hyphened(error.field()));
  if (plain != nullptr && has(plain->name)) {
    return error.named(std::string(plain->name));
  }
  if (plain == nullptr || plain->traits.dimension != Dimension::none) {
    return error;
  }
  for (const Option* option : physical_rivals(*plain)) {
    const Axis* const axis = find<Axis>(option->name);
    if (has(option->name)) {
      return {std::string(option->name),
              axis != nullptr && !axis->is_number()
                  ? axis->text()
                  : fmt::format("{} {}", *number(option->name),
                                records::units_of(option->traits.dimension).front().name),
              fmt::format("makes {}", error.what())};
    }
  }
  return error;
}

bool Settings::in_inches() const {
  return std::ranges::any_of(entries_, [](const auto& each) {
    return records::is_customary(each.second.with_unit.value_or(""));
  });
}

double Settings::required(std::string_view name, std::string_view hint) const {
  if (const auto value = number(name)) {
    return *value;
  }
  throw InputError::missing(std::string(name), std::string(hint));
}

Settings Settings::over_weight() const {
  Settings all = *this;
  for (auto& [name, entry] : all.entries_) {
    const Option& option = *find_option(name);
    if (has("gravity") && option.traits.dimension == Dimension::gravities && entry.with_unit &&
        !entry.with_unit->ends_with('g')) {
      throw InputError(std::string(name), *entry.with_unit,
                       "cannot be combined with gravity: give it in g");
    }
    const Dimension dimension =
        entry.per_weight ? option.traits.or_per_weight.dimension : option.traits.dimension;
    const bool force = dimension == Dimension::force;
    if (force || dimension == Dimension::energy) {
      const auto mass = number("mass");
      if (!mass || !(least(entry.value) >= 0)) {
        throw InputError(
            std::string(name), weighed_text(entry, dimension),
            mass ? fmt::format("must be {} of 0 or more", force ? "a force" : "an energy")
                 : fmt::format("needs a mass: give --mass as well, {}",
                               force ? "f is F/(m g)" : "delta is the energy over m g"));
      }
      const double gravity = number("gravity").value_or(design::Scales().gravity_m_per_s2);
      records::require_physical("mass", Dimension::mass, *mass);
      records::require_physical("gravity", Dimension::acceleration, gravity);
      entry.value = over(*mass * gravity, entry.value);
      entry.with_unit.reset();
      entry.per_weight = false;
    }
  }
  if (has("friction-force") && !has("f")) {
    auto force = all.entries_.extract("friction-force");
    force.key() = "f";
    all.entries_.insert(std::move(force));
  }
  return all;
}

std::vector<std::string> doubts(const Settings& settings, Command command,
                                const std::optional<design::LoadReach>& load) {
  design::GivenValues given;
  for (const auto& [option, entry] : settings.entries()) {
    const Axis* const axis = std::get_if<Axis>(&entry.value);
    const bool one_number = axis != nullptr ? axis->is_number()
                                            : std::holds_alternative<double>(entry.value) ||
                                                  std::holds_alternative<Interval>(entry.value);
    if (one_number && find_option(option)->serves(command)) {
      given[std::string(option)] = {settings.number(option).value(),
                                    entry.with_unit || (axis != nullptr && has_unit(axis->text()))};
    }
  }
  std::vector<std::string> sentences;
  for (const auto& [name, text, meant] : design::doubtful_values(given, load)) {
    sentences.push_back(fmt::format(
        "{}{}", text,
        meant ? fmt::format("; did you mean --{} {}{}?", meant->name, meant->value, meant->unit)
              : ""));
  }
  return sentences;
}

nlohmann::ordered_json as_json(const Settings::Value& value) {
  return std::visit(
      [](const auto& plain) -> nlohmann::ordered_json {
        if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, Axis>) {
          return plain.text();
        } else if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, Interval>) {
          return {plain.low, plain.high};
        } else {
          return plain;
        }
      },
      value);
}

nlohmann::ordered_json inputs(const Settings& settings, Command command) {
  nlohmann::ordered_json scene = nlohmann::ordered_json::object();
  for (const auto& [name, entry] : settings.entries()) {
    const Option& option = *find_option(name);
    if (option.traits.role == Role::input && option.serves(command)) {
      // Of a sweep this is its identity, where a single record is not a list.
      const bool lists =
          option.repeats_in(command) &&
          (!option.names_records() || command != Command::sweep || settings.texts(name).size() > 1);
      scene[std::string(name)] =
          lists ? nlohmann::ordered_json(settings.texts(name)) : as_json(entry.value);
    }
  }
  return scene;
}

}  // namespace stillpoint::cli
