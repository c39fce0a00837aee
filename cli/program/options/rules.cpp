// SPDX-License-Identifier: MIT
#include "options/settings.hpp"

namespace stillpoint::cli {

namespace {

/// A flag that is set to false is not given.
bool gives(const Settings& settings, const Option& option) {
  return option.kind == OptionKind::flag ? settings.flag(option.name) : settings.has(option.name);
}

/// Among the hits only those that the command takes count: a scene's pulse is for designs.
void require_no_rivals(const Settings& settings, Command command) {
  std::map<Rivals, std::string_view> given;
  for (const Option& option : options()) {
    const Rivals rivals = option.traits.rivals;
    if (rivals == Rivals::none || !settings.has(option.name) ||
        (rivals == Rivals::hit && !option.serves(command))) {
      continue;
    }
    const auto [first, alone] = given.emplace(rivals, option.name);
    if (!alone) {
      throw UsageError(fmt::format("{} and {} cannot be combined: give one of them", first->second,
                                   option.name));
    }
  }
}

void require_needs(const Settings& settings, Command command, const Option& option) {
  const Needs& needs = option.traits.needs;
  const auto others = needs.names();
  if (needs.commands.has(command) && std::ranges::none_of(others, [&](std::string_view other) {
        return gives(settings, *find_option(other));
      })) {
    const Option& needed = *find_option(others.front());
    throw UsageError(fmt::format("{} needs {}: give --{}{}{} as well", option.name, needs.words,
                                 needed.name, needed.placeholder.empty() ? "" : " ",
                                 needed.placeholder));
  }
}

void refuse_excluded(const Settings& settings, Command command, const Option& option) {
  for (const Excludes& excludes : option.traits.excludes) {
    for (const std::string_view other : excludes.names()) {
      if (excludes.commands.has(command) && gives(settings, *find_option(other))) {
        throw UsageError(
            fmt::format("{} and {} cannot be combined: {}", option.name, other, excludes.words));
      }
    }
  }
}

}  // namespace

void require_together(const Settings& settings, Command command) {
  require_no_rivals(settings, command);
  for (const Option& option : options()) {
    if (option.serves(command) && gives(settings, option)) {
      require_needs(settings, command, option);
      refuse_excluded(settings, command, option);
    }
  }
}

}  // namespace stillpoint::cli
