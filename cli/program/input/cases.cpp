// SPDX-License-Identifier: MIT
#include "input/cases.hpp"

#include "input/excitation.hpp"
#include "input/record.hpp"
#include "options/scene.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <utility>

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
        fmt::format("{} belongs to the damper: give it outside the cases", common->name));
  }
  return own;
}

/// Of a velocity, a pulse and records one.
void require_one_load(const Settings& settings) {
  const Option* const hit = settings.given(Rivals::hit);
  const Option* const records =
      settings.first([](const Option& option) { return option.names_records(); });
  if (hit == nullptr && records == nullptr) {
    throw UsageError("has no load: give a velocity, a pulse or a record");
  }
  if (hit != nullptr && records != nullptr) {
    throw UsageError(
        fmt::format("{} and {} cannot be combined: give one of them", hit->name, records->name));
  }
}

/// The case takes what is common to all but what it has in other words.
Settings completed(Settings own, const Settings& common) {
  Settings rest = common;
  rest.drop("cases");
  for (const Option& option : options()) {
    if (option.traits.rivals != Rivals::none && own.given(option.traits.rivals) != nullptr) {
      rest.drop(option.name);
    }
  }
  own.complete_with(rest);
  own.hold_records(common.held_records());
  return own;
}

/// A range of velocities that hit the mass.
Interval hit_of(const Settings& settings, const Physical& physical) {
  const Option& option = *settings.given(Rivals::hit);
  const double high = *settings.number(option.name);
  const double low = settings.range(option.name).value_or(Interval{high, high}).low;
  records::require_physical(option.name, option.traits.dimension, low);
  const double unit =
      option.traits.dimension == Dimension::none ? 1 : physical->scales.velocity_m_per_s;
  return {low / unit, high / unit};
}

design::PulseLoad pulse_of(const Settings& settings, const Physical& physical) {
  const auto pulse = pulse_input(settings, physical);
  const design::PulseRanges ranges = pulse_ranges(settings, pulse);
  if (ranges.lambda_high) {
    const Option& clock = *settings.given(Rivals::frequency);
    throw InputError(std::string(clock.name), *settings.number(clock.name),
                     "must be one number in a case; give a case for each length");
  }
  return {pulse.value(), ranges.k_low};
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
                       return own;
                     })});
  }
  return cases;
}

design::LoadCase load_case(const GivenCase& given, const MotionInput& start, bool one_period) {
  const auto& [name, settings] = given;
  const auto read = [&, &settings = settings] {
    design::LoadCase result;
    if (settings.has("pulse")) {
      result.pulse = pulse_of(settings, start.physical);
    } else if (settings.given(Rivals::hit) != nullptr) {
      result.v0 = hit_of(settings, start.physical);
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
    std::vector<std::string_view> names;
    for (const design::LoadCase& each : cases) {
      names.push_back(each.name);
    }
    throw InputError("objective-case", records::quoted(*wanted), must_be(*wanted, names));
  }
  return static_cast<std::size_t>(found - cases.begin());
}

}  // namespace stillpoint::cli
