// SPDX-License-Identifier: MIT
#include <stillpoint/design/excitation_kinds.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

namespace stillpoint::design {

namespace {

template <class Kind>
ExcitationKind kind_of() {
  ExcitationKind kind{.name = Kind::name};
  if constexpr (std::is_same_v<Kind, Harmonic>) {
    kind.wave = [](const Harmonic& given) { return Excitation(given); };
  } else if constexpr (!std::is_same_v<Kind, Record>) {
    kind.angle = 2 * Kind::turns * std::numbers::pi;
    kind.wave = [](const Harmonic& given) { return Excitation(Kind{given.k, given.lambda}); };
    if constexpr (std::is_constructible_v<Pulse, Kind>) {
      kind.pulse = [](const Harmonic& given) { return Pulse(Kind{given.k, given.lambda}); };
    }
  }
  return kind;
}

/// All but the first alternative, which is no excitation.
template <std::size_t... I>
auto kinds_of(std::index_sequence<I...> /*rest*/) {
  return std::array{kind_of<std::variant_alternative_t<I + 1, Excitation>>()...};
}

}  // namespace

std::span<const ExcitationKind> excitation_kinds() {
  static const auto table =
      kinds_of(std::make_index_sequence<std::variant_size_v<Excitation> - 1>());
  return table;
}

const ExcitationKind* find_excitation_kind(std::string_view name) {
  const auto kinds = excitation_kinds();
  const auto found = std::ranges::find(kinds, name, &ExcitationKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string_view> excitation_names(bool of_pulses) {
  std::vector<std::string_view> names;
  for (const ExcitationKind& kind : excitation_kinds()) {
    if (!of_pulses || kind.pulse != nullptr) {
      names.push_back(kind.name);
    }
  }
  return names;
}

}  // namespace stillpoint::design
