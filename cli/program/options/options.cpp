// SPDX-License-Identifier: MIT
#include "options/options.hpp"

namespace stillpoint::cli {

const Option* find_option(std::string_view name) {
  const auto found = std::ranges::find(options(), name, &Option::name);
  return found == options().end() ? nullptr : &*found;
}

std::vector<const Option*> physical_rivals(const Option& option) {
  std::vector<const Option*> rivals;
  for (const Option& other : options()) {
    if (option.traits.rivals != Rivals::none && other.traits.rivals == option.traits.rivals &&
        other.traits.dimension != Dimension::none) {
      rivals.push_back(&other);
    }
  }
  return rivals;
}

std::string suggestion(std::string_view wrong, std::optional<Command> command,
                       std::string_view prefix) {
  for (const Option& option : options()) {
    const auto words = records::split(option.traits.also.words, ' ');
    if (!wrong.empty() && std::ranges::find(words, wrong) != words.end()) {
      return fmt::format("; did you mean {}{}?", prefix, option.name);
    }
  }
  std::vector<std::string_view> known;
  for (const Option& option : options()) {
    if (!command || option.serves(*command)) {
      known.push_back(option.name);
    }
  }
  return records::suggestion(wrong, known, prefix);
}

}  // namespace stillpoint::cli
