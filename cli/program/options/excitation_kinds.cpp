// SPDX-License-Identifier: MIT
#include "options/excitation_kinds.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <variant>

namespace stillpoint::cli {

namespace {

template <class Result, class Wave>
Result made(const Harmonic& given) {
  if constexpr (std::is_same_v<Wave, Harmonic>) {
    return given;
  } else {
    return Wave{given.k, given.lambda};
  }
}

template <class Wave>
ExcitationKind kind_of() {
  const Excitation any = Wave{};
  if constexpr (std::is_same_v<Wave, Record>) {
    return {name(any), Load::record, 0, nullptr, nullptr};
  } else {
    const double angle = duration(made<Excitation, Wave>({0, 1})).value_or(0);
    ExcitationKind kind{name(any), angle == 0 ? Load::harmonic : Load::pulse, angle,
                        made<Excitation, Wave>, nullptr};
    if constexpr (std::is_constructible_v<design::Pulse, Wave>) {
      kind.pulse = made<design::Pulse, Wave>;
    }
    return kind;
  }
}

/// All but the first alternative, which is no excitation.
template <std::size_t... I>
auto kinds_of(std::index_sequence<I...> /*rest*/) {
  return std::array{kind_of<std::variant_alternative_t<I + 1, Excitation>>()...};
}

std::vector<std::string_view> names_where(bool (*holds)(const ExcitationKind&)) {
  std::vector<std::string_view> names;
  for (const ExcitationKind& kind : excitation_kinds()) {
    if (holds(kind)) {
      names.push_back(kind.name);
    }
  }
  return names;
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

std::vector<std::string_view> excitation_names() {
  return names_where([](const ExcitationKind&) { return true; });
}

std::vector<std::string_view> pulse_names() {
  return names_where([](const ExcitationKind& kind) { return kind.pulse != nullptr; });
}

}  // namespace stillpoint::cli
