// SPDX-License-Identifier: MIT
#pragma once

// The headers that this one brings are not listed again in this room.

#include "options/options.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/load_reach.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/sweep/list.hpp>

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

namespace stillpoint::cli {

/// Wrong use of the program that is not the value of a single field: something missing, two things
/// that cannot be combined, a file that cannot be read or written.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using records::has_unit;
using sweep::Axis;

/// The value of an option, in its SI unit; see records/units.hpp. Throws InputError.
[[nodiscard]] double parse_value(const Option& option, std::string_view text);

/// "a whole number from 1 to 1000", of an integer option.
[[nodiscard]] std::string whole_number(const Option& option);

/// What was set, by a flag or by a scene; keys are option names.
class Settings {
 public:
  using Value = std::variant<double, std::int64_t, bool, std::string, Axis, Interval>;

  struct Entry {
    Value value;
    std::optional<std::string> with_unit{};     ///< as given, if that was with a unit: "150mm"
    std::optional<records::FilePlace> place{};  ///< in a scene
    bool per_weight{false};                     ///< a force or an energy, see OrPerWeight
  };

  void set(const Option& option, Value value) { entries_[option.name].value = std::move(value); }
  void set(std::string_view name, Value value) { set(*find_option(name), std::move(value)); }
  /// An option of any kind but a flag, as on the command line: numbers may have units. Throws
  /// InputError.
  void set_text(const Option& option, const std::string& text, Command command);
  [[nodiscard]] bool has(std::string_view name) const { return entries_.contains(name); }

  /// The first option of the table that is set and for which `holds`; null if there is none.
  template <class Holds>
  [[nodiscard]] const Option* first(const Holds& holds) const {
    const auto found = std::ranges::find_if(
        options(), [&](const Option& option) { return has(option.name) && holds(option); });
    return found == options().end() ? nullptr : &*found;
  }
  /// The same of a set of rivals.
  [[nodiscard]] const Option* given(Rivals rivals) const {
    return first([&](const Option& option) { return option.traits.rivals == rivals; });
  }

  /// A range; empty if not set or if it is a number.
  [[nodiscard]] std::optional<Interval> range(std::string_view name) const {
    return get<Interval>(name);
  }

  /// The value of a number (for a range, the end that stands for it), integer, text, flag or axis
  /// option; empty (false) if not set.
  [[nodiscard]] std::optional<double> number(std::string_view name) const;
  [[nodiscard]] std::optional<std::int64_t> integer(std::string_view name) const {
    return get<std::int64_t>(name);
  }
  [[nodiscard]] std::optional<std::string> text(std::string_view name) const {
    return get<std::string>(name);
  }
  /// The values of an option that repeats, one per line.
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;
  [[nodiscard]] bool flag(std::string_view name) const { return get<bool>(name).value_or(false); }
  [[nodiscard]] std::optional<Axis> axis(std::string_view name) const { return get<Axis>(name); }

  /// Whether any value was given in inches, feet or pounds.
  [[nodiscard]] bool in_inches() const;

  /// A number; throws InputError if not set, with `hint` on what to give.
  [[nodiscard]] double required(std::string_view name, std::string_view hint) const;

  /// A text that must be one of the option's values. Throws InputError.
  [[nodiscard]] std::optional<std::string> known(std::string_view name) const;

  /// The enumerator that a text names. Throws InputError.
  template <class Enum>
  [[nodiscard]] std::optional<Enum> named(std::string_view name) const {
    const auto wanted = known(name);
    return wanted ? parse<Enum>(*wanted) : std::nullopt;
  }

  void set_place(const Option& option, records::FilePlace place) {
    entries_.at(option.name).place = std::move(place);
  }
  /// The place of the value that an InputError about `field` means; empty if it is not from a
  /// scene.
  [[nodiscard]] std::optional<records::FilePlace> place_of(std::string_view field) const;

  /// The same error by the option that was given: of --pulse-duration where it is about lambda.
  [[nodiscard]] InputError as_given(const InputError& error) const;

  /// The same, but each friction that is a force is the f = F/(m g), --friction-force too unless
  /// --f is also given, and each notch that is an energy the delta = E/(m g). Throws InputError for
  /// a wrong force or energy, for one without a mass, and for a load in m/s2 beside another g.
  [[nodiscard]] Settings over_weight() const;

  void drop(std::string_view name) { entries_.erase(name); }

  /// Records that are in memory, by the names that the option record has for them.
  void hold_records(std::shared_ptr<const records::HeldFiles> held) { held_ = std::move(held); }
  [[nodiscard]] const std::shared_ptr<const records::HeldFiles>& held_records() const {
    return held_;
  }

  /// The same of a list.
  void hold_list(std::shared_ptr<const sweep::ListColumns> list) { list_ = std::move(list); }
  [[nodiscard]] const std::shared_ptr<const sweep::ListColumns>& held_list() const { return list_; }

  /// Sets what `other` has and this does not have.
  void complete_with(const Settings& other) {
    entries_.insert(other.entries_.begin(), other.entries_.end());
  }

  /// Everything that is set, by name.
  [[nodiscard]] const std::map<std::string_view, Entry>& entries() const { return entries_; }

 private:
  /// Null if it is not set, or has another type.
  template <class T>
  [[nodiscard]] const T* find(std::string_view name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? nullptr : std::get_if<T>(&found->second.value);
  }
  template <class T>
  [[nodiscard]] std::optional<T> get(std::string_view name) const {
    const T* const found = find<T>(name);
    return found == nullptr ? std::nullopt : std::optional<T>(*found);
  }

  std::map<std::string_view, Entry> entries_;
  std::shared_ptr<const records::HeldFiles> held_;
  std::shared_ptr<const sweep::ListColumns> list_;
};

/// Whether one or more records are named.
[[nodiscard]] inline bool asks_for_records(const Settings& settings) {
  return settings.first([](const Option& option) { return option.names_records(); }) != nullptr;
}

/// Adds the option and the place in the scene to what `body` throws about a value.
template <class Body>
auto with_places(const Settings& settings, const Body& body) {
  try {
    return body();
  } catch (const InputError& error) {
    const InputError given = settings.as_given(error);
    if (const auto place = settings.place_of(given.field())) {
      throw records::FileError(*place, given.what());
    }
    throw given;
  }
}

/// Throws UsageError for options that do not go together, as their rows say: two rivals, one that
/// needs another, and one that another excludes.
void require_together(const Settings& settings, Command command);

/// Warnings about values that make no sense together, a sentence each; they are computed all the
/// same.
[[nodiscard]] std::vector<std::string> doubts(const Settings& settings, Command command,
                                              const std::optional<design::LoadReach>& load);

/// As in a scene; an axis as its text.
[[nodiscard]] nlohmann::ordered_json as_json(const Settings::Value& value);

/// The options that decide the numbers of a command, as a scene.
[[nodiscard]] nlohmann::ordered_json inputs(const Settings& settings, Command command);

}  // namespace stillpoint::cli
