// SPDX-License-Identifier: MIT
#include "sweep_columns.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace stillpoint::cli {

namespace {

using enum Quantity;

constexpr std::array motion_inputs{v0, p, x0, f, delta};
constexpr std::array design_inputs{v0, p, beta};

constexpr std::array free_results{peak_amplitude, half_cycles, outcome, stop_position, stop_time};
constexpr std::array forced_results{peak_amplitude, half_cycles, outcome,        stop_position,
                                    stop_time,      end_time,    final_position, final_velocity,
                                    sticks,         stick_time};
constexpr std::array design_results{feasible, f, delta, tolerance, peak_amplitude, stop_time};

std::span<const Quantity> results(SweepKind kind) {
  switch (kind) {
    case SweepKind::free:
      return free_results;
    case SweepKind::forced:
      return forced_results;
    case SweepKind::design:
      return design_results;
  }
  assert(false && "a SweepKind outside its enumeration");
  return {};
}

bool contains(std::span<const Quantity> list, Quantity quantity) {
  return std::ranges::find(list, quantity) != list.end();
}

std::vector<Quantity> asked_columns(std::string_view names, SweepKind kind) {
  std::vector<Quantity> columns;
  for (bool more = true; more;) {
    const std::size_t comma = names.find(',');
    more = comma != std::string_view::npos;
    const std::string_view wanted = names.substr(0, comma);
    names.remove_prefix(more ? comma + 1 : names.size());
    const auto quantity = find_quantity(wanted);
    if (!quantity ||
        !(contains(sweep_inputs(kind), *quantity) || contains(results(kind), *quantity))) {
      std::string all;
      for (const auto& part : {sweep_inputs(kind), results(kind)}) {
        for (const Quantity one : part) {
          all += fmt::format("{}{}", all.empty() ? "" : ", ", name(one));
        }
      }
      throw UsageError(fmt::format("columns: \"{}\" is none of this sweep, which has {}",
                                   records::shortened(wanted, records::longest_word), all));
    }
    if (contains(columns, *quantity)) {
      throw UsageError(fmt::format("columns: {} stands twice", wanted));
    }
    columns.push_back(*quantity);
  }
  return columns;
}

}  // namespace

std::span<const Quantity> sweep_inputs(SweepKind kind) {
  return kind == SweepKind::design ? std::span<const Quantity>(design_inputs) : motion_inputs;
}

std::vector<Quantity> sweep_columns(const Settings& settings, SweepKind kind,
                                    const std::vector<Quantity>& varying) {
  if (const auto asked = settings.text("columns")) {
    if (settings.flag("times")) {
      throw UsageError("columns and times exclude each other: name stop_time among the columns");
    }
    return asked_columns(*asked, kind);
  }
  std::vector<Quantity> columns = varying;
  for (const Quantity result : results(kind)) {
    if (result != stop_time || settings.flag("times")) {
      columns.push_back(result);
    }
  }
  return columns;
}

}  // namespace stillpoint::cli
