// SPDX-License-Identifier: MIT
#include "input/cases.hpp"

#include "input/excitation.hpp"
#include "input/record.hpp"
#include "options/scene.hpp"

#include <nlohmann/json.hpp>

namespace stillpoint::cli {

namespace {

using nlohmann::json;

/// What is wrong in a case, with its name.
template <class Body>
auto in_case(const std::string& name, const Body& body) {
  try {
    return body();
  } catch (const InputError& error) {
    throw error.named(fmt::format("{} in case {}", error.field(), name));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("case {}: {}", name, error.what()));
  }
}

/// The keys of a case that are its own.
Settings own_settings(json object) {
  object.erase("name");
  Settings own = scene_settings(object, Command::design);
  const Option* const common = own.first([](const Option& option) { return !option.is_of_case(); });
  if (common != nullptr) {
    throw UsageError(
        fmt::format("{} cannot stand in a case: give it outside of them", common->name));
  }
  return own;
}

/// What gives a case its load.
bool is_load(const Option& option) {
  return option.names_records() || (option.traits.rivals == Rivals::hit && option.is_of_case());
}

/// The case takes what is common to all but what it has in other words, or of another load.
Settings completed(Settings own, const Settings& common) {
  Settings rest = common;
  rest.drop("cases");
  rest.drop("objective-case");
  const bool has_load = own.first(is_load) != nullptr;
  const bool of_records =
      own.first([](const Option& option) { return option.names_records(); }) != nullptr;
  for (const Option& option : options()) {
    const bool rival =
        option.traits.rivals != Rivals::none && own.given(option.traits.rivals) != nullptr;
    const bool of_record = option.traits.load == Load::record || option.name == "combine";
    const bool of_load = is_load(option) || of_record || option.shapes(Load::pulse);
    if (rival || (of_records && option.names_records()) ||
        (has_load && of_load && !(of_records && of_record)) ||
        (of_records && option.name == "arrivals")) {
      rest.drop(option.name);
    }
  }
  own.complete_with(rest);
  own.hold_records(common.held_records());
  return own;
}

/// The length of a pulse is one in a case: which one is worst only its closed forms know.
void refuse_range(const Settings& settings, const Option& option) {
  if (const auto range = settings.range(option.name)) {
    throw InputError(
        std::string(option.name), fmt::format("{}:{}", range->low, range->high),
        "must be one number where motions are simulated; give a case for each in --cases");
  }
}

/// The least part of the strongest load that a range allows.
double weakest_of(const Settings& settings, std::string_view name) {
  const auto range = settings.range(name);
  if (!range) {
    return 1;
  }
  if (range->low < 0 || (range->low > 0 && range->low < design::least_weakest * range->high)) {
    throw InputError(
        std::string(name), fmt::format("{}:{}", range->low, range->high),
        fmt::format("must begin at 0, or at {} of its end or more", design::least_weakest));
  }
  return range->low / range->high;
}

double hit_of(const Settings& settings, const Physical& physical) {
  const Option& option = *settings.given(Rivals::hit);
  const double value = *settings.number(option.name);
  records::require_physical(option.name, option.traits.dimension, value);
  return option.traits.dimension == Dimension::none ? value
                                                    : value / physical->scales.velocity_m_per_s;
}

design::Pulse pulse_of(const Settings& settings, const Physical& physical) {
  if (const Option* const clock = settings.given(Rivals::frequency)) {
    refuse_range(settings, *clock);
  }
  return pulse_input(settings, physical).value();
}

/// Hits and pulses must stop the mass, at x = 0 unless a residual is allowed.
design::SuiteLimits limits_of(const Settings& settings, const Physical& physical, bool of_records) {
  const double length = physical ? physical->scales.length_m : 1;
  const auto jump = settings.number("jump-max");
  design::SuiteLimits limits{in_either(settings, "beta", length, smallest_physical),
                             settings.number("acceleration-max"),
                             in_either(settings, "residual", length, 0),
                             jump ? std::optional(*jump / physical->scales.velocity_m_per_s)
                                  : settings.number("jump-max-v")};
  if (!of_records) {
    limits.passages = static_cast<double>(settings.integer("arrivals").value_or(1) - 1);
    limits.residual = limits.residual.value_or(0);
  }
  return limits;
}

}  // namespace

std::vector<GivenCase> cases_of(const Settings& settings) {
  const auto text = settings.text("cases");
  if (!text) {
    return {{"", settings}};
  }
  const json list = json::parse(*text, nullptr, false);
  if (!list.is_array() || list.empty()) {
    throw InputError("cases", records::quoted(*text), "must be a list of at least one object");
  }
  std::vector<GivenCase> cases;
  for (const json& object : list) {
    const bool named = object.is_object() && object.contains("name") && object["name"].is_string();
    if (!named || object["name"].get<std::string>().empty()) {
      throw InputError("cases", records::quoted(object.dump()), "must have a name, a string");
    }
    const auto name = object["name"].get<std::string>();
    if (std::ranges::find(cases, name, &GivenCase::name) != cases.end()) {
      throw InputError("cases", records::quoted(name), "is the name of two cases");
    }
    cases.push_back({name, in_case(name, [&] {
                       Settings own = completed(own_settings(object), settings);
                       require_one_load(own);
                       static_cast<void>(is_physical(own, Command::design));
                       return own;
                     })});
  }
  return cases;
}

void require_one_load(const Settings& settings) {
  const Option* const load = settings.first(is_load);
  if (load == nullptr) {
    throw UsageError("no load: give a velocity, a pulse or a record");
  }
  const Option* const other = settings.first([&](const Option& option) {
    const bool records = option.names_records() && load->names_records();  // a list and files
    return is_load(option) && &option != load && !records;
  });
  if (other != nullptr) {
    throw UsageError(
        fmt::format("{} and {} cannot be combined: give one of them", load->name, other->name));
  }
  const Option* const stray = settings.first([&](const Option& option) {
    return (option.traits.load == Load::record && !load->names_records()) ||
           (option.shapes(Load::pulse) && load->name != "pulse" && !settings.has("excitation")) ||
           (option.name == "arrivals" && load->names_records()) ||
           (option.name == "combine" && !load->names_records());
  });
  if (stray != nullptr) {
    throw UsageError(fmt::format("{} means nothing with {}", stray->name, load->name));
  }
}

design::LoadCase load_case(const GivenCase& given, const MotionInput& start, bool one_period) {
  const auto& [name, settings] = given;
  const auto read = [&, &settings = settings] {
    design::LoadCase result;
    if (settings.has("pulse")) {
      result.pulse = pulse_of(settings, start.physical);
      result.weakest = weakest_of(settings, "k");
    } else if (settings.given(Rivals::hit) != nullptr) {
      result.v0 = hit_of(settings, start.physical);
      result.weakest = weakest_of(settings, settings.given(Rivals::hit)->name);
    } else {
      result.records = read_suite(settings, record_clock(start.physical, start.p),
                                  one_period ? std::optional(start.p) : std::nullopt);
    }
    result.combine = settings.named<design::Combine>("combine");
    result.limits = limits_of(settings, start.physical, result.of_records());
    return result;
  };
  design::LoadCase result = name.empty() ? read() : in_case(name, read);
  result.name = name;
  return result;
}

design::SuiteObjective usual_objective(const std::vector<design::LoadCase>& cases) {
  return std::ranges::any_of(cases, &design::LoadCase::of_records)
             ? design::SuiteObjective::acceleration
             : design::SuiteObjective::robust;
}

std::optional<std::size_t> objective_case(const Settings& settings,
                                          const std::vector<design::LoadCase>& cases) {
  const auto wanted = settings.text("objective-case");
  if (!wanted) {
    return std::nullopt;
  }
  const auto found = std::ranges::find(cases, *wanted, &design::LoadCase::name);
  if (found == cases.end()) {
    std::string names;
    for (const design::LoadCase& each : cases) {
      names += (names.empty() ? "" : ", ") + each.name;
    }
    throw InputError("objective-case", records::quoted(*wanted),
                     "must be the name of a case: " + names);
  }
  return static_cast<std::size_t>(found - cases.begin());
}

}  // namespace stillpoint::cli
