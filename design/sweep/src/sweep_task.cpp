// SPDX-License-Identifier: MIT
#include "sweep_task.hpp"

#include "digest.hpp"
#include "excitation_input.hpp"
#include "request.hpp"
#include "sweep_columns.hpp"
#include "sweep_corners.hpp"
#include "version.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/physical.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <thread>
#include <utility>

namespace stillpoint::cli {

namespace {

/// Where the entries come from, before they are put together.
struct Entries {
  std::vector<SweepAxis> axes;
  std::optional<ListReader> list;

  [[nodiscard]] bool listed(Quantity quantity) const {
    return list && std::ranges::find(list->columns(), quantity) != list->columns().end();
  }
};

std::optional<ListFormat> list_format(const Settings& settings) {
  const auto wanted = settings.text("list-format");
  if (!wanted) {
    return std::nullopt;
  }
  if (*wanted != "csv" && *wanted != "jsonl") {
    throw InputError("list-format", *wanted, "must be csv or jsonl");
  }
  return *wanted == "csv" ? ListFormat::csv : ListFormat::jsonl;
}

void open_list(const Settings& settings, Entries& entries) {
  const auto format = list_format(settings);
  if (const auto path = settings.text("list")) {
    entries.list.emplace(*path, format);
  } else if (format) {
    throw UsageError("list-format is for a list: give --list FILE as well");
  }
}

bool given(const Settings& settings, const Entries& entries, Quantity quantity) {
  return settings.has(name(quantity)) || entries.listed(quantity);
}

SweepKind kind_of(const Settings& settings, const Entries& entries) {
  if (!given(settings, entries, Quantity::beta)) {
    return settings.has("excitation") || settings.has("record") ? SweepKind::forced
                                                                : SweepKind::free;
  }
  for (const Quantity other : {Quantity::f, Quantity::delta, Quantity::x0}) {
    if (given(settings, entries, other)) {
      throw UsageError(fmt::format("beta and {} exclude each other: with beta a damper is designed",
                                   name(other)));
    }
  }
  return SweepKind::design;
}

/// What an input is where nothing is said of it; empty where that must be said.
std::optional<Axis> assumed(const Settings& settings, const Entries& entries, SweepKind kind,
                            Quantity quantity) {
  const bool set_off = kind == SweepKind::forced ||
                       (kind == SweepKind::free && given(settings, entries, Quantity::x0));
  return quantity == Quantity::x0 || (quantity == Quantity::v0 && set_off)
             ? std::optional(Axis({0}))
             : std::nullopt;
}

/// What is no column of a list has an axis.
void add_axes(const Settings& settings, SweepKind kind, Entries& entries) {
  for (const Quantity input : sweep_inputs(kind)) {
    const std::string_view option = name(input);
    auto axis = settings.axis(option);
    if (entries.listed(input)) {
      if (axis) {
        throw UsageError(fmt::format("{} is a column of the list and an option: give one", option));
      }
      continue;
    }
    if (!axis) {
      axis = assumed(settings, entries, kind, input);
    }
    if (!axis) {
      throw InputError::missing(
          std::string(option),
          fmt::format("give --{}: a number, a range first:last:count or numbers a,b,c{}", option,
                      entries.list ? "; or a column of the list" : ""));
    }
    if (entries.list && axis->size() > 1) {
      throw UsageError(fmt::format(
          "list and {} exclude each other: beside a list an option has one value", option));
    }
    entries.axes.push_back({input, *axis});
  }
}

std::vector<Quantity> varying(const Entries& entries, SweepKind kind) {
  std::vector<Quantity> inputs;
  for (const Quantity input : sweep_inputs(kind)) {
    const bool spread = std::ranges::any_of(entries.axes, [input](const SweepAxis& swept) {
      return swept.quantity == input && swept.axis.size() > 1;
    });
    if (spread || entries.listed(input)) {
      inputs.push_back(input);
    }
  }
  return inputs;
}

RowFormat row_format(const Settings& settings) {
  const auto output = settings.text("output");
  const auto wanted = settings.text("format");
  if (wanted && *wanted != "csv" && *wanted != "npy") {
    throw InputError("format", *wanted, "must be csv or npy");
  }
  return (wanted ? *wanted == "npy" : output && output->ends_with(".npy")) ? RowFormat::npy
                                                                           : RowFormat::csv;
}

int thread_count(const Settings& settings) {
  constexpr std::int64_t most = 1024;
  const auto wanted = settings.integer("threads");
  if (wanted && (*wanted < 1 || *wanted > most)) {
    throw InputError("threads", fmt::format("{}", *wanted),
                     fmt::format("must be a whole number from 1 to {}", most));
  }
  return static_cast<int>(wanted.value_or(std::max(1U, std::thread::hardware_concurrency())));
}

/// Options that only one kind uses are refused with another, not passed over.
void refuse_for_other_kinds(const Settings& settings, SweepKind kind) {
  if (kind == SweepKind::design) {
    for (const char* const other : {"excitation", "record", "t-end", "half-cycle-limit"}) {
      if (settings.has(other)) {
        throw UsageError(fmt::format("beta and {} exclude each other", other));
      }
    }
    return;
  }
  for (const char* const other : {"criterion", "objective", "tolerance", "f-max", "delta-max"}) {
    if (settings.has(other)) {
      throw UsageError(fmt::format("{} is for designs: give --beta as well", other));
    }
  }
  if (kind == SweepKind::free && settings.has("t-end")) {
    throw UsageError("t-end is for an excitation: give --excitation as well");
  }
}

void add_motion(SweepTask& task, const Settings& settings) {
  task.half_cycle_limit = half_cycle_limit(settings);
  const auto input = excitation_input(settings, {.unit = "tau"}, design::Scales().gravity_m_per_s2);
  if (!input) {
    return;
  }
  task.excitation = input->excitation;
  task.t_end = settings.number("t-end");
  if (task.t_end) {
    require_within("t-end", *task.t_end, smallest_speed, largest_speed);
  } else if (std::isinf(duration(task.excitation))) {
    throw InputError::missing("t-end", "give --t-end, the excitation never ends");
  }
}

void add_design(SweepTask& task, const Settings& settings) {
  task.criterion = criterion(settings);
  task.search.objective = objective(settings);
  task.limits.f_max = settings.number("f-max");
  task.limits.delta_max = settings.number("delta-max");
  task.limits.tolerance = settings.number("tolerance").value_or(0);
}

/// Of a record the file may change, so its values count.
std::uint64_t record_digest(const Excitation& excitation) {
  Digest digest;
  if (const auto* const record = std::get_if<Record>(&excitation)) {
    digest.add(record->step);
    std::ranges::for_each(record->values, [&](double value) { digest.add(value); });
    std::ranges::for_each(record->times, [&](double time) { digest.add(time); });
  }
  return digest.value();
}

nlohmann::ordered_json identity(const SweepTask& task, const Settings& settings) {
  nlohmann::ordered_json result;
  result["version"] = program_version();
  result["kind"] = name(task.kind);
  result["format"] = name(task.format);
  for (const Quantity column : task.columns) {
    result["columns"].push_back(name(column));
  }
  result["list"] = settings.has("list");
  settings.for_each([&](std::string_view option, const Settings::Value& value) {
    if (!decides_rows(option) || !find_option(option)->serves(Command::sweep)) {
      return;
    }
    const std::string key(option);
    if (const auto* const axis = std::get_if<Axis>(&value)) {
      result[key] = axis->text();
    } else {
      std::visit(
          [&](const auto& plain) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(plain)>, Axis>) {
              result[key] = plain;
            }
          },
          value);
    }
  });
  result["record_digest"] = record_digest(task.excitation);
  return result;
}

}  // namespace

std::string_view name(SweepKind kind) noexcept {
  switch (kind) {
    case SweepKind::free:
      return "free";
    case SweepKind::forced:
      return "forced";
    case SweepKind::design:
      return "design";
  }
  assert(false && "a SweepKind outside its enumeration");
  return "";
}

std::string_view name(RowFormat format) noexcept {
  return format == RowFormat::csv ? "csv" : "npy";
}

SweepTask sweep_task(const Settings& settings) {
  SweepTask task;
  task.output = settings.text("output");
  task.format = row_format(settings);
  task.threads = thread_count(settings);
  task.resume = settings.flag("resume");
  Entries entries;
  open_list(settings, entries);
  task.kind = kind_of(settings, entries);
  refuse_for_other_kinds(settings, task.kind);
  if (task.kind == SweepKind::design) {
    add_design(task, settings);
  } else {
    add_motion(task, settings);
  }
  add_axes(settings, task.kind, entries);
  const std::vector<Quantity> spread = varying(entries, task.kind);
  const auto spreads = [&spread](Quantity input) {
    return std::ranges::find(spread, input) != spread.end();
  };
  task.columns = sweep_columns(settings, task.kind, spread);
  task.times = std::ranges::find(task.columns, Quantity::stop_time) != task.columns.end();
  task.one_v0_and_p = !spreads(Quantity::v0) && !spreads(Quantity::p);
  task.from_zero = !given(settings, entries, Quantity::x0);
  task.identity = identity(task, settings).dump();
  if (!entries.list) {
    check_corners(entries.axes, task);
  }
  task.listed = entries.list.has_value();
  task.axes = entries.axes;
  task.source = entries.list ? list_source(std::move(*entries.list), std::move(entries.axes))
                             : grid_source(std::move(entries.axes));
  return task;
}

}  // namespace stillpoint::cli
