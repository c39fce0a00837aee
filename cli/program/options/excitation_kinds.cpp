// SPDX-License-Identifier: MIT
#include "options/excitation_kinds.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace stillpoint::cli {

namespace {

template <class Result, class Wave>
Result of(const Harmonic& given) {
  return Wave{given.k, given.lambda};
}

Excitation itself(const Harmonic& given) {
  return given;
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
  using design::Pulse;
  using std::numbers::pi;
  static const std::array table{
      // name, load, angle, wave, pulse
      ExcitationKind{"harmonic", Load::harmonic, 0, itself, nullptr},
      ExcitationKind{"half-sine", Load::pulse, pi, of<Excitation, HalfSine>, of<Pulse, HalfSine>},
      ExcitationKind{"full-sine", Load::pulse, 2 * pi, of<Excitation, FullSine>,
                     of<Pulse, FullSine>},
      ExcitationKind{"rectangle", Load::pulse, pi, of<Excitation, Rectangle>, of<Pulse, Rectangle>},
      ExcitationKind{"record", Load::record, 0, nullptr, nullptr},
  };
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
