// SPDX-License-Identifier: MIT
#include "excitation_kinds.hpp"

#include <algorithm>
#include <array>

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
  static const std::array table{
      // name, takes, wave, pulse
      ExcitationKind{"harmonic", {"k", "lambda", "phase", "duration"}, itself, nullptr},
      ExcitationKind{"half-sine", {"k", "lambda"}, of<Excitation, HalfSine>, of<Pulse, HalfSine>},
      ExcitationKind{"full-sine", {"k", "lambda"}, of<Excitation, FullSine>, nullptr},
      ExcitationKind{"rectangle", {"k", "lambda"}, of<Excitation, Rectangle>, of<Pulse, Rectangle>},
      ExcitationKind{
          "record", {"record", "record-units", "record-step", "record-scale"}, nullptr, nullptr},
  };
  return table;
}

bool ExcitationKind::has(std::string_view option) const {
  return std::ranges::find(takes, option) != takes.end();
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
