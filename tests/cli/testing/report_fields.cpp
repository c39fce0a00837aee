// SPDX-License-Identifier: MIT
#include "report_fields.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace stillpoint::cli_test {

namespace {

using nlohmann::json;

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

void check_near(const json& object, std::initializer_list<std::pair<const char*, double>> values,
                double tolerance) {
  for (const auto& [name, value] : values) {
    const double found = object.at(name).get<double>();
    BOOST_TEST(near(found, value, tolerance), name << " is " << found << ", not " << value);
  }
}

const nlohmann::json& motion_of(const nlohmann::json& report) {
  return report.at("cases").at(0).at("motions").at(0);
}

void check_only_finite(std::string_view report) {
  const std::string ended = std::string(report) + '\n';
  std::string word;
  for (const char letter : ended) {
    const auto c = static_cast<unsigned char>(letter);
    if (c == '_' || std::isalnum(c) != 0) {
      word.push_back(static_cast<char>(std::tolower(c)));
      continue;
    }
    if (word == "nan" || word == "inf" || word == "infinity") {
      BOOST_ERROR("a report has " << word);
    }
    word.clear();
  }
}

json without_wall_times(json report) {
  remove_wall_times(report);
  return report;
}

json Sandbox::reported(const Arguments& arguments, const Surroundings& surroundings) const {
  const ProgramRun run = succeed(arguments + "--json", surroundings);
  static const std::regex remarks(
      "(stillpoint: (caution|fault): .*\n)*"
      "(stillpoint: (no notch |with this notch ).*\n)?"
      "(stillpoint: The notch locks .*\n)?");
  BOOST_TEST(std::regex_match(run.err, remarks), run.err);
  check_only_finite(run.out);
  return run.json();
}

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

}  // namespace stillpoint::cli_test
