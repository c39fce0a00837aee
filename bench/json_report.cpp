// SPDX-License-Identifier: MIT
#include "reports.hpp"

#include <stillpoint/records/decimal.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace stillpoint::bench {

namespace {

using Json = nlohmann::ordered_json;

/// Measured figures with their significant digits.
double four_digits(double value) {
  return records::decimal(value, 4);
}

Json time(const peers::Timing& timing) {
  return {{"median", four_digits(timing.median)},
          {"lower_quartile", four_digits(timing.low)},
          {"upper_quartile", four_digits(timing.high)},
          {"batches", timing.batches}};
}

Json row(const Row& row, bool has_setting) {
  Json json;
  json["setting"] = has_setting ? Json(four_digits(row.setting)) : Json();
  json["seconds"] = time(row.time);
  json["error_of_peak"] = four_digits(row.verdict.peak);
  json["error_of_end"] = four_digits(row.verdict.end);
  json["counts"] = row.verdict.counts;
  json["counts_right"] = row.verdict.counts_right;
  return json;
}

Json ratios(const SceneRows& scene) {
  Json json = Json::array();
  for (const double bound : {1e-6, 1e-8, 1e-10}) {
    if (const auto rival = best_rival(scene, bound)) {
      json.push_back({{"largest_error", bound},
                      {"best", rival->method->method.name},
                      {"setting", four_digits(rival->row->setting)},
                      {"ratio", four_digits(rival->ratio)}});
    }
  }
  return json;
}

Json scene(const SceneRows& from) {
  const peers::Result& truth = from.scene.truth;
  Json json;
  json["name"] = from.scene.name;
  json["what"] = from.scene.legend;
  json["reference"] = {{"peak", truth.peak}, {"counts", counts_of(truth)}};
  if (from.scene.free) {
    json["reference"]["stop_time"] = truth.end_time;
  } else {
    json["reference"]["x"] = truth.x;
    json["reference"]["v"] = truth.v;
  }
  for (const MethodRows& rows : from.methods) {
    Json method{{"name", rows.method.name},
                {"what", rows.method.what},
                {"knob", rows.method.knob},
                {"rows", Json::array()}};
    for (const Row& one : rows.rows) {
      method["rows"].push_back(row(one, !rows.method.knob.empty()));
    }
    json["methods"].push_back(method);
  }
  json["ratios"] = ratios(from);
  return json;
}

}  // namespace

std::string json_report(const Comparison& comparison) {
  const Machine& machine = comparison.machine;
  Json json;
  json["machine"] = {{"processor", machine.processor},
                     {"cores", machine.cores},
                     {"system", machine.system},
                     {"compiler", machine.compiler},
                     {"flags", machine.flags},
                     {"libraries", machine.libraries},
                     {"date", machine.date}};
  json["seconds_of_run"] = four_digits(comparison.seconds);
  for (const SceneRows& one : comparison.scenes) {
    json["scenes"].push_back(scene(one));
  }
  for (const Unit& unit : comparison.free_modes) {
    json["free_kernel"].push_back({{"what", unit.what}, {"seconds", time(unit.seconds)}});
  }
  json["many_dampers"] = {{"what", "S6: eleven records, 10000 dampers"},
                          {"run_one_by_one", comparison.many.sampled},
                          {"error_of_peak_of_rk4", four_digits(comparison.many.error_of_peak)},
                          {"wrong_counts_of_rk4", four_digits(comparison.many.wrong_counts)}};
  for (const Unit& unit : comparison.many.rows) {
    json["many_dampers"]["rows"].push_back({{"what", unit.what}, {"seconds", time(unit.seconds)}});
  }
  return json.dump() + "\n";
}

}  // namespace stillpoint::bench
