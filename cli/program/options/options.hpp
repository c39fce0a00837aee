// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/names.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/units.hpp>
#include <stillpoint/sweep/axis.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace stillpoint::cli {

enum class Command { design, region, simulate, spectrum, sweep, accuracy, init, explore };

using stillpoint::name;

/// Some of the commands: design | sweep.
class CommandSet {
 public:
  constexpr CommandSet() = default;
  // One command is a set of one. NOLINTNEXTLINE(google-explicit-constructor)
  constexpr CommandSet(Command one) : bits_(1U << static_cast<unsigned>(one)) {}

  [[nodiscard]] constexpr bool has(Command command) const {
    return (bits_ & CommandSet(command).bits_) != 0;
  }
  friend constexpr CommandSet operator|(CommandSet a, CommandSet b) {
    a.bits_ |= b.bits_;
    return a;
  }

 private:
  unsigned bits_{0};
};

constexpr CommandSet operator|(Command a, Command b) {
  return CommandSet(a) | CommandSet(b);
}

/// An axis is one number or many, see Axis.
enum class OptionKind { number, integer, text, flag, axis };

/// What an option is for. Reports echo the first three as a scene; rows of a resumed sweep depend
/// only on `input` and on the entries themselves.
enum class Role {
  input,      ///< decides the numbers
  entries,    ///< where a sweep's entries come from
  content,    ///< which of the numbers are reported
  execution,  ///< how they are computed; they do not depend on it
  output,     ///< where they go
};

/// Sets of options of which at most one may be given.
enum class Rivals {
  none,
  hit,
  stiffness,
  stroke,
  start,
  friction,
  point_friction,
  point_friction_limit,
  jump_limit,
  residual,
  frequency,
  duration,
  end,
  notch,
  record_scale,
  verbosity,
};

using records::Dimension;
using records::listed;
using records::must_be;
using records::suggestion;

/// A task is given either dimensionless or in metres and seconds, not both. Beside records gravity
/// turns their m/s2 into g and says nothing of the task.
enum class Units { any, dimensionless, physical, physical_without_records };

using sweep::RangeEnd;

enum class FileUse { none, read, written, directory };

/// Besides the value of the command line a scene may have a list of zones or of cases, or an object
/// that groups the options under the same heading.
enum class InScene { plain, zones, cases, group };

/// Which loads, or pulses, an option shapes; a wave is a harmonic or a pulse.
enum class Load { none, harmonic, pulse, wave, record };

/// What only one kind of design takes: one for a hit or a pulse by its closed forms, or one under
/// records. What is for `cases` makes a single case of a hit or a pulse.
enum class DesignFor { both, hit, records, cases };

/// Of a whole number.
struct Bounds {
  std::int64_t least{0};
  std::int64_t most{0};
};

/// In some commands other options, of which an option needs one to mean anything; and what they
/// stand for, "a trajectory".
struct Needs {
  CommandSet commands{};
  std::string_view options{};  ///< with blanks between them
  std::string_view words{};

  [[nodiscard]] std::vector<std::string_view> names() const { return records::split(options, ' '); }
};

/// The commands that take an option in Python, where results are objects, and what it is there.
struct InPython {
  CommandSet commands{};
  std::string_view help{};  ///< empty: as elsewhere
};

/// The commands in which a number is an axis.
struct Swept : CommandSet {};
/// A physical option of that dimension.
struct InSi {
  Dimension dimension;
};
struct Values {
  std::vector<std::string_view> (*all)(){nullptr};
  bool first_is_default{false};
};
/// Beside none of which it can be given; and why.
struct Excludes : Needs {};
/// Other words for it, with blanks between them.
struct Also {
  std::string_view words{};
};
/// What to give where it is refused: "a design takes --pulse".
struct Instead {
  std::string_view words{};
};
/// It may also have a unit of that dimension, force or energy, and is that over the weight then.
struct OrPerWeight {
  Dimension dimension{Dimension::none};
};
enum class Trait { repeats, limits_case, not_explored };

/// What an option is besides its name and help: any of these facts, each of a type of its own.
struct OptionTraits {
  Swept axis{};
  Rivals rivals{Rivals::none};
  Units units{Units::any};
  Dimension dimension{Dimension::none};
  OrPerWeight or_per_weight{};
  Role role{Role::input};
  FileUse file{FileUse::none};
  Values values{};                    ///< all that a text may have; none: any text
  std::string (*in_help)(){nullptr};  ///< where the help does not have the values
  RangeEnd range{RangeEnd::none};     ///< for designs LOW:HIGH is a value as well
  DesignFor design{DesignFor::both};
  bool limits_case{false};  ///< each case of a design may have its own
  Load load{Load::none};
  Bounds bounds{};  ///< of an integer
  InScene in_scene{InScene::plain};
  Needs needs{};
  std::array<Excludes, 2> excludes{};
  Also also{};
  Instead instead{};
  std::optional<InPython> python{};  ///< empty: what its role says
  bool repeats{false};  ///< may be given several times; a file, to commands that take a suite
  bool explored{true};  ///< if the page with the program in it can take it

  template <class... Facts>
  explicit constexpr OptionTraits(const Facts&... facts) {
    (set(facts), ...);
  }

 private:
  template <class Fact>
  constexpr void set(const Fact& fact) {
    std::get<Fact&>(std::tie(axis, rivals, units, dimension, or_per_weight, role, file, values,
                             in_help, range, design, load, bounds, in_scene, needs, also,
                             instead)) = fact;
  }
  constexpr void set(const InSi& fact) {
    units = Units::physical;
    dimension = fact.dimension;
  }
  constexpr void set(const Excludes& fact) { excludes[excludes[0].options.empty() ? 0 : 1] = fact; }
  constexpr void set(const InPython& fact) { python = fact; }
  constexpr void set(Trait fact) {
    repeats = repeats || fact == Trait::repeats;
    limits_case = limits_case || fact == Trait::limits_case;
    explored = explored && fact != Trait::not_explored;
  }
};

/// One option of the program: a flag --name on the command line and a key of a scene file, where
/// '-' and '_' are the same.
struct Option {
  std::string_view name;
  OptionKind kind;
  std::string_view placeholder;  ///< in --help
  CommandSet commands;
  OptionTraits traits{};
  std::string_view group{};  ///< heading in --help
  std::string_view help{};   ///< its line in data/help/options.txt

  /// All that a text may have; empty: any text.
  [[nodiscard]] std::vector<std::string_view> values() const {
    return traits.values.all == nullptr ? std::vector<std::string_view>() : traits.values.all();
  }
  [[nodiscard]] bool serves(Command command) const { return commands.has(command); }
  [[nodiscard]] OptionKind kind_in(Command command) const {
    return traits.axis.has(command) ? OptionKind::axis : kind;
  }
  [[nodiscard]] bool repeats_in(Command command) const {
    return traits.repeats &&
           (traits.file == FileUse::none ||
            (Command::design | Command::region | Command::spectrum | Command::sweep).has(command));
  }
  [[nodiscard]] bool takes_range_in(Command command) const {
    return traits.range != RangeEnd::none &&
           (Command::design | Command::region | Command::sweep).has(command);
  }
  /// What it takes besides a single value, for its help; a sweep says what an axis is.
  [[nodiscard]] std::string more_values_in(Command command) const {
    return command == Command::spectrum && traits.axis.has(command) ? "; first:last:count"
           : command == Command::sweep || !takes_range_in(command) ||
                   help.find("LOW:HIGH") != std::string_view::npos
               ? ""
               : "; LOW:HIGH for a range";
  }
  [[nodiscard]] std::string help_in(Command command) const {
    return std::string(help) + more_values_in(command);
  }
  [[nodiscard]] bool shapes(Load load) const {
    return traits.load != Load::none &&
           (traits.load == load ||
            (traits.load == Load::wave && (load == Load::harmonic || load == Load::pulse)));
  }
  [[nodiscard]] DesignFor design_for() const {
    return traits.load == Load::record ? DesignFor::records
           : shapes(Load::pulse)       ? DesignFor::hit
                                       : traits.design;
  }
  /// Whether it may stand in one of the cases of a design: its load, and what is required under it.
  [[nodiscard]] bool is_of_case() const {
    return traits.limits_case || names_records() || traits.load == Load::record ||
           shapes(Load::pulse) || (traits.rivals == Rivals::hit && serves(Command::design));
  }
  /// In Python files that show a report do not exist.
  [[nodiscard]] bool serves_in_python(Command command) const {
    return serves(command) &&
           (traits.python ? traits.python->commands.has(command) : traits.role != Role::output);
  }
  /// Whether a report repeats it in its scene.
  [[nodiscard]] bool is_echoed() const { return traits.role <= Role::content; }
  [[nodiscard]] bool takes_file() const {
    return traits.file == FileUse::read || traits.file == FileUse::written;
  }
  /// Whether the page with the program in it takes it.
  [[nodiscard]] bool is_explored() const {
    return traits.explored && is_echoed() && (serves(Command::design) || serves(Command::region)) &&
           (!takes_file() || name == "record");
  }
  [[nodiscard]] bool names_records() const {
    return traits.file == FileUse::read && design_for() == DesignFor::records;
  }
};

/// Every option of every command, in the order of --help.
[[nodiscard]] std::span<const Option> options();

/// The option of that name, of any command; null if there is none.
[[nodiscard]] const Option* find_option(std::string_view name);

/// The options that can replace it and have a unit.
[[nodiscard]] std::vector<const Option*> physical_rivals(const Option& option);

/// "; did you mean NAME?" for an option that is meant, or one or two slips away, else "". Options
/// of `command` come first. The prefix is put before it.
[[nodiscard]] std::string suggestion(std::string_view wrong,
                                     std::optional<Command> command = std::nullopt,
                                     std::string_view prefix = "");

}  // namespace stillpoint::cli
