// SPDX-License-Identifier: MIT
#include "excitation_input.hpp"
#include "request.hpp"
#include "surface_input.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/report/version.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <thread>

namespace stillpoint::cli {

namespace {

using sweep::Axis;
using sweep::Quantity;
using sweep::SweepKind;
using sweep::SweepSpec;

std::optional<sweep::ListFormat> list_format(const Settings& settings) {
  const auto wanted = settings.known("list-format");
  if (!wanted) {
    return std::nullopt;
  }
  return *wanted == "csv" ? sweep::ListFormat::csv : sweep::ListFormat::jsonl;
}

std::shared_ptr<sweep::List> open_list(const Settings& settings) {
  const auto format = list_format(settings);
  if (const auto path = settings.text("list")) {
    return std::make_shared<sweep::List>(*path, format);
  }
  if (format) {
    throw UsageError("list-format is for a list: give --list FILE as well");
  }
  return {};
}

bool given(const Settings& settings, const SweepSpec& spec, Quantity quantity) {
  return settings.has(name(quantity)) || (spec.list && spec.list->has(quantity));
}

SweepKind kind_of(const Settings& settings, const SweepSpec& spec) {
  if (!given(settings, spec, Quantity::beta)) {
    return excitation_type(settings) ? SweepKind::forced : SweepKind::free;
  }
  for (const Quantity other : {Quantity::f, Quantity::delta, Quantity::x0}) {
    if (given(settings, spec, other)) {
      throw UsageError(
          fmt::format("beta and {} exclude each other: beta asks for a design", name(other)));
    }
  }
  return SweepKind::design;
}

/// Options that only one kind uses are refused with another, not ignored.
void refuse_for_other_kinds(const Settings& settings, SweepKind kind) {
  if (kind == SweepKind::design) {
    for (const char* const other : {"excitation", "record", "t-end", "half-cycle-limit"}) {
      if (settings.has(other)) {
        throw UsageError(fmt::format("beta and {} exclude each other", other));
      }
    }
    return;
  }
  for (const Option& option : options()) {
    const bool of_designs = option.serves(Command::design) && !option.serves(Command::simulate);
    if (of_designs && option.serves(Command::sweep) && settings.has(option.name)) {
      throw UsageError(fmt::format("{} is for designs: give --beta as well", option.name));
    }
  }
  if (kind == SweepKind::free && settings.has("t-end")) {
    throw UsageError("t-end is for an excitation: give --excitation as well");
  }
}

/// Where nothing else is given a motion starts from x = 0, and from rest if something else moves
/// it.
void add_axes(const Settings& settings, SweepSpec& spec) {
  const bool may_rest = spec.kind == SweepKind::forced ||
                        (spec.kind == SweepKind::free && given(settings, spec, Quantity::x0));
  for (const Quantity input : sweep::inputs(spec.kind)) {
    if (const auto axis = settings.axis(name(input))) {
      spec.axes.push_back({input, *axis});
    } else if (!given(settings, spec, input) &&
               (input == Quantity::x0 || (input == Quantity::v0 && may_rest))) {
      spec.axes.push_back({input, Axis({0})});
    }
  }
}

void add_motion(const Settings& settings, SweepSpec& spec) {
  spec.half_cycle_limit = half_cycle_limit(settings);
  const auto input = excitation_input(settings, {.unit = "tau"}, design::Scales().gravity_m_per_s2);
  if (!input) {
    return;
  }
  spec.excitation = input->excitation;
  spec.t_end = forced_end(settings, spec.excitation);
}

void add_design(const Settings& settings, SweepSpec& spec) {
  spec.criterion = criterion(settings);
  spec.search.objective = objective(settings);
  spec.limits.f_max = settings.number("f-max");
  spec.limits.delta_max = settings.number("delta-max");
  spec.limits.tolerance = settings.number("tolerance").value_or(0);
}

std::vector<Quantity> columns(const Settings& settings, const SweepSpec& spec) {
  const auto asked = settings.text("columns");
  const bool times = settings.flag("times");
  if (asked && times) {
    throw UsageError("columns and times exclude each other: name stop_time among the columns");
  }
  return asked ? sweep::parse_columns(*asked, spec.kind) : sweep::default_columns(spec, times);
}

sweep::RowFormat row_format(const Settings& settings) {
  const auto output = settings.text("output");
  const auto wanted = settings.known("format");
  const bool npy = wanted ? *wanted == "npy" : output && output->ends_with(".npy");
  return npy ? sweep::RowFormat::npy : sweep::RowFormat::csv;
}

/// The file of a record may change, so its values count.
std::uint64_t record_digest(const Excitation& excitation) {
  sweep::Digest digest;
  if (const auto* const record = std::get_if<Record>(&excitation)) {
    digest.add(record->step);
    std::ranges::for_each(record->values, [&](double value) { digest.add(value); });
    std::ranges::for_each(record->times, [&](double time) { digest.add(time); });
  }
  return digest.value();
}

/// SweepSpec::identity: the options that decide the rows, as they were given.
std::string identity(const Settings& settings, const SweepSpec& spec) {
  nlohmann::ordered_json result;
  result["version"] = report::program_version();
  result["kind"] = name(spec.kind);
  result["format"] = name(spec.format);
  for (const Quantity column : spec.columns) {
    result["columns"].push_back(name(column));
  }
  result["list"] = spec.list != nullptr;
  for (const auto& [option, value] : settings.values()) {
    const Option& known = *find_option(option);
    if (known.traits.role == Role::input && known.serves(Command::sweep)) {
      result[std::string(option)] = as_json(value);
    }
  }
  result["record_digest"] = record_digest(spec.excitation);
  return result.dump();
}

}  // namespace

SweepSpec sweep_request(const Settings& settings) {
  require_paper_notch(settings, Command::sweep);
  SweepSpec spec;
  spec.output = settings.text("output");
  spec.format = row_format(settings);
  const std::int64_t all_threads = std::max(1U, std::thread::hardware_concurrency());
  spec.threads = static_cast<int>(settings.count("threads", all_threads, 1, 1024));
  spec.resume = settings.flag("resume");
  spec.list = open_list(settings);
  spec.kind = kind_of(settings, spec);
  refuse_for_other_kinds(settings, spec.kind);
  if (spec.kind == SweepKind::design) {
    add_design(settings, spec);
  } else {
    add_motion(settings, spec);
  }
  add_axes(settings, spec);
  spec.columns = columns(settings, spec);
  spec.identity = identity(settings, spec);
  require_valid(spec);
  return spec;
}

}  // namespace stillpoint::cli
