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
                                      "locked_from_s",
                                      "largest_load_while_locked",
                                      "peak_m_without_notch",
                                      "residual_m_without_notch",
                                      "peak_absolute_acceleration_without_notch"};

double period_s(const SpectrumReport& report, std::size_t point) {
  return 2 * std::numbers::pi / report.result.request.p[point] * report.physical.scales.time_s;
}

std::optional<double> metres(const SpectrumReport& report, const std::optional<double>& length) {
  return length ? std::optional(*length * report.physical.scales.length_m) : std::nullopt;
}

std::optional<double> locked_from_s(const SpectrumReport& report,
                                    const design::SpectrumFigures& figures) {
  return figures.locked_from ? std::optional(*figures.locked_from * report.physical.scales.time_s)
                             : std::nullopt;
}

void add_figures(ordered_json& json, const SpectrumReport& report,
                 const design::SpectrumFigures& figures) {
  json["peak_m"] = number(metres(report, figures.peak));
  json["residual_m"] = number(metres(report, figures.residual));
  json["peak_absolute_acceleration"] = number(figures.acceleration);
}

ordered_json points_json(const SpectrumReport& report,
                         const std::vector<design::SpectrumPoint>& points) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    ordered_json point{{"period_s", number(period_s(report, i))}};
    const design::SpectrumFigures& with_notch = points[i].with_notch;
    add_figures(point, report, with_notch);
    point["locked_from_s"] = number(locked_from_s(report, with_notch));
    point["largest_load_while_locked"] = number(with_notch.largest_load_while_locked);
    add_figures(point["without_notch"], report, points[i].without);
    list.push_back(std::move(point));
  }
  return list;
}

/// Of the file; empty where a value does not exist.
using SpectrumRow = std::array<std::optional<double>, spectrum_columns.size()>;

template <class Write>
void for_each_row(const SpectrumReport& report, const Write& write) {
  const auto& records = report.result.records;
  for (std::size_t record = 0; record < records.size(); ++record) {
    for (std::size_t i = 0; i < records[record].size(); ++i) {
      const auto& [with_notch, without] = records[record][i];
      write(SpectrumRow{static_cast<double>(record + 1), period_s(report, i),
                        metres(report, with_notch.peak), metres(report, with_notch.residual),
                        with_notch.acceleration, locked_from_s(report, with_notch),
                        with_notch.largest_load_while_locked, metres(report, without.peak),
                        metres(report, without.residual), without.acceleration});
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
                       {"scale", number(task.records[i].scale)},
                       {"points", points_json(report, report.result.records[i])}});
  }
  return {{"schema", "stillpoint/spectrum-report/1"},
          {"program", program_json()},
          {"input",
           {{"f", number(task.f)},
            {"delta_m", number(metres(report, task.delta))},
            {"hold", number(task.hold)},
            {"notch_width_m", number(metres(report, task.notch_width))},
            {"combine", name(task.combine.value())},
            {"gravity_m_per_s2", number(report.physical.scales.gravity_m_per_s2)}}},
          {"combined", points_json(report, report.result.combined)},
          {"records", std::move(records)}};
}

}  // namespace stillpoint::report
