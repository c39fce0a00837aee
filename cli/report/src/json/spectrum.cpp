// SPDX-License-Identifier: MIT
#include "json/parts.hpp"

#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/sweep/npy.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// The columns of the files; those of the JSON are the same, without_notch an object of its own.
constexpr std::array spectrum_columns{"record",
                                      "period_s",
                                      "peak_m",
                                      "residual_m",
                                      "peak_absolute_acceleration",
                                      "jump_m_per_s",
                                      "locked_from_s",
                                      "largest_load_while_locked",
                                      "peak_m_without_notch",
                                      "residual_m_without_notch",
                                      "peak_absolute_acceleration_without_notch"};

constexpr std::size_t first_without = 8;  // of the columns
constexpr std::size_t first_figure = 2;   // which has the same quantity as that one

/// Empty where a value does not exist.
using SpectrumRow = std::array<std::optional<double>, spectrum_columns.size()>;

SpectrumRow row_of(const SpectrumReport& report, std::size_t record, std::size_t place,
                   const design::SpectrumPoint& point) {
  const double time_s = report.physical.scales.time_s;
  const double length_m = report.physical.scales.length_m;
  const auto times = [](const std::optional<double>& value, double unit) {
    return value ? std::optional(*value * unit) : std::nullopt;
  };
  const auto& [with_notch, without] = point;
  return {static_cast<double>(record + 1),
          2 * std::numbers::pi / report.result.request.p[place] * time_s,
          with_notch.peak * length_m,
          times(with_notch.residual, length_m),
          with_notch.acceleration,
          with_notch.jump * report.physical.scales.velocity_m_per_s,
          times(with_notch.locked_from, time_s),
          with_notch.largest_load_while_locked,
          without.peak * length_m,
          times(without.residual, length_m),
          without.acceleration};
}

ordered_json points_json(const SpectrumReport& report,
                         const std::vector<design::SpectrumPoint>& points) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SpectrumRow row = row_of(report, 0, i, points[i]);
    ordered_json& json = list.emplace_back();
    for (std::size_t column = 1; column < first_without; ++column) {
      json[spectrum_columns.at(column)] = row.at(column);
    }
    ordered_json& without = json["without_notch"];
    for (std::size_t column = first_without; column < row.size(); ++column) {
      without[spectrum_columns.at(column - first_without + first_figure)] = row.at(column);
    }
  }
  return list;
}

template <class Write>
void for_each_row(const SpectrumReport& report, const Write& write) {
  const auto& records = report.result.records;
  for (std::size_t record = 0; record < records.size(); ++record) {
    for (std::size_t i = 0; i < records[record].size(); ++i) {
      write(row_of(report, record, i, records[record][i]));
    }
  }
}

}  // namespace

std::string spectrum_csv(const SpectrumReport& report) {
  std::string text;
  for (const char* const column : spectrum_columns) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", column);
  }
  text += '\n';
  for_each_row(report, [&](const SpectrumRow& row) {
    for (const std::optional<double>& value : row) {
      text += value ? fmt::format("{},", *value) : ",";
    }
    text.back() = '\n';
  });
  return text;
}

std::string spectrum_npy(const SpectrumReport& report) {
  std::string fields;
  for (const char* const column : spectrum_columns) {
    fields += sweep::npy_number(column);
  }
  const std::size_t rows = report.result.records.size() * report.result.request.p.size();
  std::string bytes = sweep::npy_header(fields, static_cast<std::int64_t>(rows));
  for_each_row(report, [&](const SpectrumRow& row) {
    for (const std::optional<double>& value : row) {
      const double written = value.value_or(std::numeric_limits<double>::quiet_NaN());
      std::array<char, sizeof written> raw{};
      std::memcpy(raw.data(), &written, sizeof written);
      bytes.append(raw.data(), raw.size());
    }
  });
  return bytes;
}

ordered_json json(const SpectrumReport& report) {
  const design::SpectrumRequest& task = report.result.request;
  ordered_json records = ordered_json::array();
  for (std::size_t i = 0; i < task.records.size(); ++i) {
    records.push_back({{"file", task.records[i].name},
                       {"scale", task.records[i].scale},
                       {"units", name(task.records[i].units)},
                       {"units_assumed", task.records[i].assumed_g},
                       {"pga", design::peak_load(task.records[i])},
                       {"points", points_json(report, report.result.records[i])}});
  }
  return {{"schema", "stillpoint/spectrum-report/1"},
          {"program", program_json()},
          {"input",
           {{"f", task.f},
            {"delta_m", metres(report.physical, task.delta)},
            {"hold", task.hold},
            {"notch_width_m", metres(report.physical, task.notch_width)},
            {"combine", name(task.combine.value())},
            {"gravity_m_per_s2", report.physical.scales.gravity_m_per_s2}}},
          {"combined", points_json(report, report.result.combined)},
          {"records", std::move(records)}};
}

}  // namespace stillpoint::report
