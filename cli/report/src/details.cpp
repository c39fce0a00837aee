// SPDX-License-Identifier: MIT
// A report in full: each object of its JSON is a section, each of its values a row.
#include "sections.hpp"

#include <array>
#include <cctype>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// What a name ends in, and the unit of its value; prefixes suit some.
struct SiUnit {
  std::string_view suffix;
  std::string_view unit;
  bool prefixed{false};
};
// Those that end in others first.
constexpr std::array si_units{SiUnit{"_m_per_s2", "m/s2"},
                              SiUnit{si_suffix(Dimension::velocity), "m/s"},
                              SiUnit{"_rad_per_s", "rad/s"},
                              SiUnit{"_n_per_m", "N/m", true},
                              SiUnit{si_suffix(Dimension::impulse), "N s", true},
                              SiUnit{si_suffix(Dimension::force), "N", true},
                              SiUnit{si_suffix(Dimension::energy), "J", true},
                              SiUnit{"_kg", "kg"},
                              SiUnit{"_hz", "Hz"},
                              SiUnit{si_suffix(Dimension::length), "m", true},
                              SiUnit{si_suffix(Dimension::time), "s", true}};

SiUnit unit_of(std::string_view name) {
  const auto* const found =
      std::ranges::find_if(si_units, [&](const SiUnit& now) { return name.ends_with(now.suffix); });
  return found == si_units.end() ? SiUnit{} : *found;
}

/// "0.0241172", "5.8993 mm", "0.341 to 0.429 m/s", "yes", "robust"
std::string value_words(const ordered_json& value, const SiUnit& unit) {
  if (value.is_array()) {
    std::string words;
    for (const ordered_json& item : value) {
      words += (words.empty()                                                ? ""
                : value.size() == 2 && !item.is_string() && !item.is_array() ? " to "
                                                                             : ", ") +
               value_words(item, unit);
    }
    return words;
  }
  return value.is_null()             ? "none"
         : value.is_boolean()        ? value.get<bool>() ? "yes" : "no"
         : value.is_string()         ? spelled_out(value.get<std::string>())
         : value.is_number_integer() ? value.dump()
         : unit.prefixed             ? with_unit(value.get<double>(), unit.unit)
         : unit.unit.empty()         ? digits(value.get<double>())
                                     : format("{} {}", digits(value.get<double>()), unit.unit);
}

bool is_list_of_objects(const ordered_json& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

/// Whether it is in SI units as well.
bool has_twin(const ordered_json& object, const std::string& name) {
  return std::ranges::any_of(si_units, [&](const SiUnit& now) {
    const auto twin = object.find(name + std::string(now.suffix));
    return twin != object.end() && !twin->is_null();
  });
}

/// A row for each value of an object and of those in it. Long lists are left to --json.
void add_fields(Section& section, const ordered_json& object, const std::string& before) {
  constexpr std::size_t longest_list = 12;
  for (const auto& [name, value] : object.items()) {
    const SiUnit unit = unit_of(name);
    const bool passed_over = name == "response" || name == "motions";
    const std::string inside = passed_over ? before : before + name + "_";
    // The name of a part stands before its fields, that of a motion may be a long path; times
    // differ from run to run; the verdict says the reason, in the units of the task.
    const bool left_out = name == "of" || name == "motion" || name == "physical" ||
                          name == "wall_time_s" || name == "rows_per_s" || name == "reason" ||
                          (name == "name" && !before.empty());
    if (value.is_null() || left_out || has_twin(object, name)) {
      continue;
    }
    if (value.is_object()) {
      add_fields(section, value, inside);
    } else if (is_list_of_objects(value)) {
      for (const ordered_json& item : value) {
        if (item.contains("name") && item["name"].is_string()) {
          add_fields(section, item, before + item["name"].get<std::string>() + "_");
        } else if (value.size() == 1) {
          add_fields(section, item, inside);
        }
      }
    } else if (!value.is_array() || (!value.empty() && value.size() <= longest_list)) {
      section.row(in_words(before + name.substr(0, name.size() - unit.suffix.size())),
                  value_words(value, unit));
    }
  }
}

}  // namespace

void add_details(Document& document, const ordered_json& report) {
  // The head, what the answer says, and long tables that have a form of their own.
  static constexpr auto elsewhere = std::to_array<std::string_view>(
      {"schema", "program", "verdict", "findings", "constraints", "mends", "strips", "hits",
       "half_cycles", "catalogue", "trade_off"});
  ordered_json own = ordered_json::object();
  const auto add = [&](std::string heading, const ordered_json& object) {
    heading.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(heading.front())));
    Section& section = document.detail(std::move(heading));
    add_fields(section, object, "");
  };
  for (const auto& [name, value] : report.items()) {
    if (std::ranges::find(elsewhere, name) != elsewhere.end()) {
      continue;
    }
    if (value.is_object()) {
      add(in_words(name), value);
    } else if (is_list_of_objects(value)) {
      constexpr std::size_t few = 3;
      for (std::size_t i = 0; value.size() <= few && i < value.size(); ++i) {
        add(in_words(name), value[i]);
      }
    } else {
      own[name] = value;
    }
  }
  add("report", own);
}

}  // namespace stillpoint::report
