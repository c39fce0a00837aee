// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/motion_fields.hpp"
#include "json/schema.hpp"

#include <stillpoint/report/schemas.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/sweep/npy.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace stillpoint {

template <>
inline constexpr auto fields<design::SpectrumFigures> = [] {
  using Now = design::SpectrumFigures;
  using report::si_always;
  return std::tuple{Field{"peak_m", &Now::peak, "", si_always(Dimension::length)},
                    Field{"residual_m", &Now::residual,
                          "null where the mass does not come to rest within 10 000 half-cycles",
                          si_always(Dimension::length)},
                    Field{"peak_absolute_acceleration", &Now::acceleration, "in g"}};
}();

}  // namespace stillpoint

namespace stillpoint::report {

namespace {

constexpr auto spectrum_name = std::to_array<std::string_view>({"stillpoint/spectrum-report/1"});

/// A point of the spectrum with its spring.
struct ShownPoint : design::SpectrumPoint {
  double p{1};

  static constexpr auto field_table = std::tuple_cat(
      std::tuple{Field{"period_s", [](const auto& now) { return turn(now.p); }, "",
                       si_always(Dimension::time)}},
      fields_in(&ShownPoint::with_notch, fields<design::SpectrumFigures>),
      fields_in(
          &ShownPoint::with_notch,
          std::tuple{Field{"jump_m_per_s", &design::SpectrumFigures::jump, "",
                           si_always(Dimension::velocity)},
                     Field{"locked_from_s", &design::SpectrumFigures::locked,
                           "null where the mass does not lock, like the next; for several records "
                           "the earliest and the largest",
                           si_always(Dimension::time)},
                     Field{"largest_load_while_locked",
                           &design::SpectrumFigures::largest_load_while_locked}}),
      std::tuple{Field{"without_notch", &ShownPoint::without}});
};
struct SpectrumInput {
  const design::SpectrumRequest& request;
  double gravity_m_per_s2;

  using Now = SpectrumInput;
  static constexpr std::tuple field_table{
      Field{"f", [](const auto& now) { return now.request.f; }},
      Field{"delta_m", [](const auto& now) { return now.request.delta; }, "",
            si_always(Dimension::length)},
      Field{"hold", [](const auto& now) { return now.request.hold; },
            "null with the paper's notch, like notch_width_m"},
      Field{"notch_width_m", [](const auto& now) { return now.request.notch_width; }, "",
            si_always(Dimension::length)},
      Field{"combine", [](const auto& now) { return now.request.combine.value(); }},
      Field{"gravity_m_per_s2", &Now::gravity_m_per_s2}};
};
struct ShownRecord {
  const design::SuiteRecord& record;
  std::vector<ShownPoint> points;

  using Now = ShownRecord;
  static constexpr std::tuple field_table{
      Field{"file", [](const auto& now) { return now.record.name; }, "", any_number},
      Field{"scale", [](const auto& now) { return now.record.scale; }, "", any_number},
      Field{"units", [](const auto& now) { return now.record.units; }, "of the values in the file"},
      Field{"units_assumed", [](const auto& now) { return now.record.assumed_g; },
            "whether neither the file nor an option gives them"},
      Field{"pga", [](const auto& now) { return design::peak_load(now.record); },
            "the largest |W| in g, scaled"},
      Field{"points", &Now::points, "", at_least_one}};
};

std::vector<ShownPoint> points_of(const SpectrumReport& report,
                                  const std::vector<design::SpectrumPoint>& points) {
  std::vector<ShownPoint> shown;
  shown.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    shown.push_back({points[i], report.result.request.p[i]});
  }
  return shown;
}

std::vector<ShownRecord> records_of(const SpectrumReport& report) {
  const design::Spectrum& result = report.result;
  std::vector<ShownRecord> shown;
  shown.reserve(result.records.size());
  for (std::size_t i = 0; i < result.records.size(); ++i) {
    shown.push_back({result.request.records[i], points_of(report, result.records[i])});
  }
  return shown;
}

constexpr auto spectrum_table = std::tuple_cat(
    head_fields<SpectrumReport, spectrum_name>, told_fields<SpectrumReport>,
    std::tuple{
        Field{
            "input",
            [](const SpectrumReport& report) {
              return SpectrumInput{report.result.request, report.physical.scales.gravity_m_per_s2};
            }},
        Field{
            "combined",
            [](const SpectrumReport& report) { return points_of(report, report.result.combined); },
            "an entry for each period", at_least_one},
        Field{"records", &records_of, "", at_least_one}});

/// Calls `use` with the name and the value of each column of a row but the record's.
template <class Use>
void for_each_column(const ShownPoint& point, const design::Scales& scales, const Use& use) {
  const auto add = [&](const auto& field, const std::optional<double>& value,
                       std::string_view suffix) {
    use(std::string(field.name).append(suffix),
        value ? scales.in_si(field.measure.dimension, *value) : value);
  };
  for_each_field(fields<ShownPoint>, [&](const auto& field) {
    const auto& value = std::invoke(field.get, point);
    if constexpr (HasFields<std::remove_cvref_t<decltype(value)>>) {
      for_each_field(fields<design::SpectrumFigures>, [&](const auto& figure) {
        add(figure, std::invoke(figure.get, value), "_without_notch");
      });
    } else {
      add(field, value, "");
    }
  });
}

/// Empty where a value does not exist.
using SpectrumRow = std::vector<std::optional<double>>;

std::vector<std::string> columns() {
  std::vector<std::string> names{"record"};
  for_each_column({}, {}, [&](std::string name, const auto&) { names.push_back(std::move(name)); });
  return names;
}

template <class Write>
void for_each_row(const SpectrumReport& report, const Write& write) {
  double number = 0;
  for (const std::vector<design::SpectrumPoint>& record : report.result.records) {
    ++number;
    for (const ShownPoint& point : points_of(report, record)) {
      SpectrumRow row{number};
      for_each_column(point, report.physical.scales,
                      [&](const auto&, const auto& value) { row.push_back(value); });
      write(row);
    }
  }
}

}  // namespace

std::string spectrum_csv(const SpectrumReport& report) {
  std::string text = fmt::format("{}\n", fmt::join(columns(), ","));
  for_each_row(report, [&](const SpectrumRow& row) {
    for (const std::optional<double>& value : row) {
      text += value ? fmt::format("{},", *value) : ",";
    }
    text.back() = '\n';
  });
  return text;
}

std::string spectrum_npy(const SpectrumReport& report) {
  std::string npy_fields;
  for (const std::string& column : columns()) {
    npy_fields += sweep::npy_number(column);
  }
  const std::size_t rows = report.result.records.size() * report.result.request.p.size();
  std::string bytes = sweep::npy_header(npy_fields, static_cast<std::int64_t>(rows));
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

nlohmann::ordered_json json(const SpectrumReport& report) {
  return object_by<spectrum_table>(report, &report.physical.scales);
}

nlohmann::ordered_json spectrum_schema() {
  return report_schema<SpectrumReport>(spectrum_table, spectrum_name.front(), "spectrum --json",
                                       "In metres, seconds and g");
}

}  // namespace stillpoint::report
