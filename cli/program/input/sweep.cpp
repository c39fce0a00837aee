// SPDX-License-Identifier: MIT
#include "input/excitation.hpp"
#include "input/record.hpp"
#include "input/request.hpp"

#include <stillpoint/design/excitation_kinds.hpp>
#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/sweep/checkpoint.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <filesystem>
#include <thread>

namespace stillpoint::cli {

namespace {

using sweep::Axis;
using sweep::Quantity;
using sweep::SweepKind;
using sweep::SweepSpec;
using sweep::SweepUnits;

std::shared_ptr<sweep::List> open_list(const Settings& settings,
                                       const std::optional<SweepUnits>& units) {
  const auto path = settings.text("list");
  if (path && settings.held_list()) {
    return std::make_shared<sweep::List>(settings.held_list(), units);
  }
  return path ? std::make_shared<sweep::List>(*path, units) : nullptr;
}

bool given(const Settings& settings, const SweepSpec& spec, Quantity quantity) {
  return settings.has(option_name(quantity, spec.units)) || (spec.list && spec.list->has(quantity));
}

/// Options made dimensionless by a length that a physical sweep does not have, with rivals in
/// metres, seconds or hertz. The factor on a record and friction depend on no unit.
void refuse_dimensionless(const Settings& settings) {
  const Option* const plain = settings.first([](const Option& option) {
    return option.kind == OptionKind::number && option.traits.dimension == Dimension::none &&
           option.traits.rivals != Rivals::record_scale &&
           option.traits.rivals != Rivals::friction && !physical_rivals(option).empty();
  });
  if (plain != nullptr) {
    throw UsageError(fmt::format("{} is dimensionless: with physical input give --{}", plain->name,
                                 physical_rivals(*plain).front()->name));
  }
}

/// Empty for dimensionless input.
std::optional<SweepUnits> units(const Settings& settings) {
  if (!is_physical(settings, Command::sweep)) {
    return std::nullopt;
  }
  refuse_dimensionless(settings);
  SweepUnits units;
  units.gravity_m_per_s2 = settings.number("gravity").value_or(units.gravity_m_per_s2);
  records::require_physical("gravity", Dimension::acceleration, units.gravity_m_per_s2);
  if (settings.has("stiffness")) {
    units.restoring = sweep::Restoring::stiffness;
    units.mass_kg = settings.required("mass", "stiffness needs a mass as well");
    records::require_physical("mass", Dimension::mass, units.mass_kg);
  } else if (settings.has("natural-frequency")) {
    units.restoring = sweep::Restoring::natural_frequency;
  }
  if (const auto pulse = settings.known("pulse")) {
    units.pulse_angle = design::find_excitation_kind(*pulse)->angle;
    units.pulse_clock =
        settings.has("pulse-duration") ? design::WaveClock::duration : design::WaveClock::frequency;
  }
  return units;
}

SweepKind kind_of(const Settings& settings, const SweepSpec& spec) {
  if (!given(settings, spec, Quantity::beta)) {
    return excitation_type(settings) || asks_for_records(settings) ? SweepKind::forced
                                                                   : SweepKind::free;
  }
  const std::string beta = option_name(Quantity::beta, spec.units);
  for (const Quantity other :
       {Quantity::f, Quantity::delta, Quantity::x0, Quantity::hold, Quantity::notch_width}) {
    if (given(settings, spec, other)) {
      throw UsageError(fmt::format("{0} and {1} cannot be combined: {0} asks for a design", beta,
                                   option_name(other, spec.units)));
    }
  }
  return SweepKind::design;
}

/// Inputs of a sweep that only motions use, or only designs.
bool is_of_motions(const Option& option) {
  return option.traits.role == Role::input &&
         (option.names_records() ||
          (option.serves(Command::simulate) &&
           (!option.serves(Command::design) || option.traits.load == Load::record)));
}
bool is_of_designs(const Option& option) {
  return option.traits.role == Role::input && option.serves(Command::design) &&
         option.serves(Command::sweep) && !option.serves(Command::simulate) &&
         !option.names_records();
}

/// Options that only one kind uses are refused with the others, not ignored.
void refuse_for_other_kinds(const Settings& settings, const SweepSpec& spec) {
  const std::string beta = option_name(Quantity::beta, spec.units);
  if (spec.kind == SweepKind::design) {
    if (const Option* const wrong = settings.first(is_of_motions)) {
      throw UsageError(fmt::format("{} and {} cannot be combined", beta, wrong->name));
    }
    return;
  }
  if (const Option* const wrong = settings.first(is_of_designs)) {
    throw UsageError(fmt::format("{} needs a design: give --{} as well", wrong->name, beta));
  }
  const Option* const end = settings.given(Rivals::end);
  if (spec.kind == SweepKind::free && end != nullptr) {
    throw UsageError(fmt::format("{} needs an excitation: give --excitation as well", end->name));
  }
}

void add_axes(const Settings& settings, SweepSpec& spec) {
  for (const Quantity input : sweep::inputs(spec.kind)) {
    if (const auto front = settings.integer("trade-off"); front && input == Quantity::trade_off) {
      spec.axes.push_back(
          {input, Axis(1, static_cast<double>(*front), *front, Axis::Spacing::linear)});
    } else if (const auto axis = settings.axis(option_name(input, spec.units));
               axis && (input != Quantity::record_scale || !spec.records.empty())) {
      spec.axes.push_back({input, *axis});
    }
  }
  add_default_start(spec);
}

/// Whether the rows have a record each, or a scale of their own.
bool several_records(const Settings& settings) {
  const auto paths = settings.texts("record");
  const auto scales = settings.axis("record-scale");
  return settings.has("records-list") || paths.size() > 1 ||
         (!paths.empty() &&
          ((scales && scales->size() > 1) || std::filesystem::is_directory(paths[0])));
}

/// Each is read once; a scale of all is that of their rows.
void add_records(const Settings& settings, const Physical& physical, SweepSpec& spec) {
  require_options_of_record(settings);
  Settings unscaled = settings;
  unscaled.drop("record-scale");
  for (auto& [name, record, scale, units, assumed_g] :
       read_suite(unscaled, record_clock(physical, 1), {})) {
    const double factor = scale;
    std::ranges::for_each(record.values, [factor](double& value) { value *= factor; });
    require_valid(Excitation(record));
    spec.records.push_back({std::move(name), std::move(record)});
  }
  const std::int64_t count = std::ssize(spec.records);
  spec.axes.push_back(
      {Quantity::record, Axis(0, static_cast<double>(count - 1), count, Axis::Spacing::linear)});
  if (!settings.has("record-scale")) {
    spec.axes.push_back({Quantity::record_scale, Axis({1})});
  }
  spec.excitation = spec.records.front().record;
  spec.t_end = end_of_run(settings, physical);
}

void add_motion(const Settings& settings, SweepSpec& spec) {
  spec.half_cycle_limit = half_cycle_limit(settings);
  const Physical physical = spec.units ? std::optional(spec.units->physical()) : std::nullopt;
  spec.zones = friction_zones(settings, physical);
  if (several_records(settings)) {
    add_records(settings, physical, spec);
  } else if (const auto input = excitation_input(settings, physical, {})) {
    spec.excitation = input->excitation;
    spec.t_end = forced_end(settings, spec.excitation, physical);
  }
}

void add_design(const Settings& settings, SweepSpec& spec) {
  if (const auto pulse = settings.known("pulse")) {
    spec.pulse = design::find_excitation_kind(*pulse)->pulse({});
  } else {
    require_no_pulse_options(settings);
  }
  spec.task.criterion = criterion(settings);
  for (const Quantity beyond : {Quantity::damping, Quantity::breakaway}) {
    if (given(settings, spec, beyond) && settings.has("criterion") &&
        spec.task.criterion == design::Criterion::published) {
      throw UsageError(published_beyond(name(beyond)));
    }
  }
  spec.search.objective = objective(settings);
  for (const design::LimitKind& kind : design::limit_kinds()) {
    const bool in_metres = spec.units && !kind.in_metres.empty();
    spec.limits.*kind.value =
        settings.number(records::hyphened(in_metres ? kind.in_metres : kind.field));
  }
  spec.limits.tolerance = tolerance_of_hit(settings);
  shape_box(settings, spec.limits);
  if (settings.has("catalogue")) {  // with units the unit of length is a metre
    spec.parts = catalogue_input(
        settings, spec.units ? sweep::CatalogueUnits{.length_m = 1, .metres_only = true}
                             : sweep::CatalogueUnits());
  }
}

std::vector<Quantity> columns(const Settings& settings, const SweepSpec& spec) {
  const auto asked = settings.text("columns");
  return asked ? sweep::parse_columns(*asked, spec.kind, spec.units)
               : sweep::default_columns(spec, settings.flag("times"));
}

/// What is kept from the rows that are not written.
std::optional<sweep::ReductionRequest> reduction(const Settings& settings, const SweepSpec& spec) {
  if (!settings.flag("reduce")) {
    return std::nullopt;
  }
  sweep::ReductionRequest asked;
  for (const std::string& bins : settings.texts("histogram")) {
    asked.histograms.push_back(sweep::parse_bins(bins, spec.columns, spec.units));
  }
  return asked;
}

sweep::RowFormat row_format(const Settings& settings) {
  const bool npy =
      !settings.flag("reduce") && settings.text("output").value_or("").ends_with(".npy");
  return settings.named<sweep::RowFormat>("format").value_or(npy ? sweep::RowFormat::npy
                                                                 : sweep::RowFormat::csv);
}

/// Rows whose format is not asked for have that of the ending; a device or a pipe may have none.
void require_ending(const Settings& settings) {
  const std::string output = settings.text("output").value_or("-");
  const bool needs_none = settings.has("format") || settings.flag("reduce") || output.empty() ||
                          output == "-" || sweep::is_special_file(output);
  if (!needs_none && !output.ends_with(".csv") && !output.ends_with(".npy")) {
    throw InputError("output", output, "must end in .csv or .npy, or give --format csv or npy");
  }
}

}  // namespace

void resolve_part(Settings& settings) {
  const auto asked = settings.text("part");
  if (!asked) {
    return;
  }
  const sweep::SweepPart part = sweep::parse_part(*asked);
  settings.set("part", text(part));
  if (const auto output = settings.text("output")) {
    settings.set("output", sweep::with_part(*output, part));
  }
}

SweepSpec sweep_request(const Settings& given) {
  const Settings settings = given.over_weight();
  SweepSpec spec;
  spec.output = settings.text("output");
  spec.format = row_format(settings);
  const int all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  spec.threads = threads(settings).value_or(all);
  spec.resume = settings.flag("resume");
  spec.units = units(settings);
  spec.list = open_list(settings, spec.units);
  if (const auto part = settings.text("part")) {
    spec.part = sweep::parse_part(*part);
  }
  if (spec.part && spec.list) {
    spec.listed = spec.list->whole();
  }
  spec.kind = kind_of(settings, spec);
  refuse_for_other_kinds(settings, spec);
  if (spec.kind == SweepKind::design) {
    add_design(settings, spec);
  } else {
    add_motion(settings, spec);
  }
  add_axes(settings, spec);
  spec.columns = columns(settings, spec);
  spec.reduction = reduction(settings, spec);
  spec.identity =
      identity_of(spec, inputs(settings, Command::sweep).dump(), report::program_version());
  require_valid(spec);
  require_ending(settings);
  return spec;
}

}  // namespace stillpoint::cli
