// SPDX-License-Identifier: MIT
#include "report_fields.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <regex>

namespace stillpoint::cli_test {

namespace {

using nlohmann::json;

bool is_kind(const json& value, std::string_view kind) {
  if (kind.ends_with('?')) {
    kind.remove_suffix(1);
    if (value.is_null()) {
      return true;
    }
  }
  if (kind == "number") {
    return value.is_number() && std::isfinite(value.get<double>());
  }
  if (kind == "count") {
    return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
  }
  return (kind == "text" && value.is_string()) || (kind == "bool" && value.is_boolean()) ||
         (kind == "object" && value.is_object()) || (kind == "array" && value.is_array()) ||
         (kind == "null" && value.is_null());
}

void remove_wall_times(json& value) {
  if (value.is_object()) {
    value.erase("wall_time_s");
  }
  if (value.is_structured()) {
    for (json& part : value) {
      remove_wall_times(part);
    }
  }
}

}  // namespace

void check_fields(const json& object, std::initializer_list<std::string_view> fields) {
  BOOST_TEST_REQUIRE(object.is_object());
  for (const std::string_view field : fields) {
    const std::size_t colon = field.find(':');
    const std::string name(field.substr(0, colon));
    BOOST_TEST_CONTEXT("field " << field) {
      BOOST_TEST(object.contains(name));
      BOOST_TEST(is_kind(object.value(name, json("missing")), field.substr(colon + 1)));
    }
  }
}

void check_values(const json& object, std::initializer_list<std::pair<const char*, json>> values) {
  for (const auto& [name, value] : values) {
    BOOST_TEST_CONTEXT("field " << name) {
      BOOST_TEST(object.value(name, json("missing")) == value);
    }
  }
}

void check_near(const json& object, std::initializer_list<std::pair<const char*, double>> values,
                double tolerance) {
  for (const auto& [name, value] : values) {
    const double found = object.at(name).get<double>();
    BOOST_TEST(near(found, value, tolerance), name << " is " << found << ", not " << value);
  }
}

void check_response_fields(const json& response) {
  check_fields(response, {"peak_amplitude:number", "peak_acceleration:number",
                          "peak_absolute_acceleration:number", "half_cycles:count",
                          "turning_points:count", "zero_passages:count", "stop_time:number",
                          "stop_position:number", "stops_at_zero:bool", "outcome:text",
                          "arrival_speed:number?", "decision_margin:number?"});
}

void check_only_finite(std::string_view report) {
  static const std::regex not_finite("\\b(nan|inf|infinity)\\b", std::regex::icase);
  BOOST_TEST(!std::regex_search(report.begin(), report.end(), not_finite));
}

json without_wall_times(json report) {
  remove_wall_times(report);
  return report;
}

json Sandbox::reported(const Arguments& arguments, const Surroundings& surroundings) const {
  const ProgramRun run = succeed(arguments + "--json", surroundings);
  const bool says_that_it_locks = (run.err.starts_with("stillpoint: locked at x = 0 ") ||
                                   run.err.starts_with("stillpoint: locked: ") ||
                                   run.err.starts_with("stillpoint: never starts: ")) &&
                                  run.err.find('\n') + 1 == run.err.size();
  BOOST_TEST((run.err.empty() || says_that_it_locks), run.err);
  check_only_finite(run.out);
  return run.json();
}

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

}  // namespace stillpoint::cli_test
