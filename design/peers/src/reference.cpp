// SPDX-License-Identifier: MIT
#include <stillpoint/peers/reference.hpp>

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace stillpoint::peers {

namespace {

using Row = std::map<std::string, std::string>;  // by column

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> list;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) {
    list.push_back(cell);
  }
  return list;
}

/// The row of a table whose first column is `name`.
Row row(const std::string& file_name, const std::string& name) {
  std::ifstream file(file_name);
  std::vector<std::string> columns;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) {
      continue;
    }
    const std::vector<std::string> values = cells(line);
    if (columns.empty()) {
      columns = values;
    } else if (values.size() == columns.size() && values[0] == name) {
      Row found;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        found[columns[i]] = values[i];
      }
      return found;
    }
  }
  throw std::runtime_error(file_name + " has no row " + name);
}

double number(const Row& row, const std::string& column) {
  const std::string& text = row.at(column);
  double value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) {
    throw std::runtime_error(column + " is no number: " + text);
  }
  return value;
}

std::int64_t count(const Row& row, const std::string& column) {
  return std::llround(number(row, column));
}

/// The record of make_forced_reference.py: multiples of 2^-36, which every library rounds alike.
Record record_s5() {
  Record record;
  record.step = 0.02;
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 0.02;
    const double first = (t - 20) / 10;
    const double second = (t - 25) / 12;
    const double w = 0.4 * std::exp(-first * first) * std::sin(2.3 * t) +
                     0.2 * std::exp(-second * second) * std::sin(5.1 * t + 1);
    record.values.push_back(std::ldexp(std::nearbyint(std::ldexp(w, 36)), -36));
  }
  return record;
}

Scene inputs(const Row& row) {
  Scene scene;
  scene.oscillator = {number(row, "p"), number(row, "f"), number(row, "delta")};
  scene.start = {number(row, "x0"), number(row, "v0")};
  return scene;
}

ReferenceScene free_scene(const std::string& folder, const std::string& row_name, std::string name,
                          std::string legend) {
  const Row from = row(folder + "/free_motion.csv", row_name);
  if (from.at("outcome") != "stopped_at_zero") {
    throw std::runtime_error(row_name + " should stop at zero");
  }
  ReferenceScene to{std::move(name), std::move(legend), true, inputs(from), {}};
  to.truth.outcome = Outcome::stopped_at_zero;
  to.truth.peak = number(from, "peak_amplitude");
  to.truth.end_time = number(from, "stop_time");
  to.truth.passages = count(from, "zero_passages");
  to.truth.turns = count(from, "turning_points");
  to.scene.t_end = 4 * to.truth.end_time;
  return to;
}

ReferenceScene forced_scene(const std::string& folder, const std::string& row_name,
                            std::string name, std::string legend) {
  const Row from = row(folder + "/forced_motion.csv", row_name);
  ReferenceScene to{std::move(name), std::move(legend), false, inputs(from), {}};
  if (from.at("k") == "record") {
    Record record = record_s5();
    to.scene.t_end = record.step * static_cast<double>(record.values.size() - 1);
    to.scene.excitation = std::move(record);
    // It rests inside the dead zone when the record ends, and for ever.
    to.truth.outcome = Outcome::stopped_in_dead_zone;
  } else {
    to.scene.t_end = number(from, "t_end");
    to.scene.excitation =
        Harmonic{number(from, "k"), number(from, "lambda"), number(from, "phase")};
  }
  to.truth.peak = number(from, "peak_amplitude");
  to.truth.end_time = to.scene.t_end;
  to.truth.x = number(from, "final_position");
  to.truth.v = number(from, "final_velocity");
  to.truth.passages = count(from, "zero_passages");
  to.truth.turns = count(from, "turning_points");
  to.truth.sticks = count(from, "sticks");
  return to;
}

}  // namespace

std::vector<ReferenceScene> reference_scenes(const std::string& reference_folder) {
  const std::string& at = reference_folder;
  return {
      free_scene(at, "scene_s1", "S1", "free, both frictions, 11 half-cycles"),
      free_scene(at, "scene_s2", "S2", "free, little friction, 424 half-cycles"),
      free_scene(at, "design_first_return_published", "FR", "free, a first-return design"),
      forced_scene(at, "scene_s3", "S3", "resonance, both frictions, to 200"),
      forced_scene(at, "scene_s4", "S4", "slow harmonic, 22 sticks, to 200"),
      forced_scene(at, "scene_s5", "S5", "a record of 3000 samples"),
  };
}

}  // namespace stillpoint::peers
