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

namespace stillpoint::report {

namespace {

constexpr auto spectrum_name = std::to_array<std::string_view>({"stillpoint/spectrum-report/1"});

/// In metres and seconds.
struct ShownFigures {
  const design::SpectrumFigures& figures;
  const design::Scales& scales;
};
struct ShownPoint : ShownFigures {
  double period_s{0};
  ShownFigures without;
};
struct SpectrumInput {
  const design::SpectrumRequest& request;
  const design::Scales& scales;
};
struct ShownRecord {
  const design::SuiteRecord& record;
  std::vector<ShownPoint> points;
};

std::vector<ShownPoint> points_of(const SpectrumReport& report,
                                  const std::vector<design::SpectrumPoint>& points) {
  const design::Scales& scales = report.physical.scales;
  std::vector<ShownPoint> shown;
  shown.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double period = 2 * std::numbers::pi / report.result.request.p[i] * scales.time_s;
    shown.push_back({{points[i].with_notch, scales}, period, {points[i].without, scales}});
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

}  // namespace

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::ShownFigures> = [] {
  using report::ShownFigures;
  return std::tuple{
      Field{"peak_m",
            [](const ShownFigures& now) { return now.figures.peak * now.scales.length_m; }},
      Field{"residual_m",
            [](const ShownFigures& now) {
              return report::times(now.figures.residual, now.scales.length_m);
            },
            "null where the mass does not come to rest within 10 000 half-cycles"},
      Field{"peak_absolute_acceleration",
            [](const ShownFigures& now) { return now.figures.acceleration; }, "in g"}};
}();

template <>
inline constexpr auto fields<report::ShownPoint> = [] {
  using report::ShownFigures;
  using report::ShownPoint;
  return std::tuple_cat(
      std::tuple{Field{"period_s", &ShownPoint::period_s}}, fields<ShownFigures>,
      std::tuple{
          Field{"jump_m_per_s",
                [](const ShownFigures& now) {
                  return now.figures.jump * now.scales.velocity_m_per_s;
                }},
          Field{"locked_from_s",
                [](const ShownFigures& now) {
                  return report::times(now.figures.locked_from, now.scales.time_s);
                },
                "null where the mass does not lock, like the next; for several records the "
                "earliest and the largest"},
          Field{"largest_load_while_locked",
                [](const ShownFigures& now) { return now.figures.largest_load_while_locked; }},
          Field{"without_notch", &ShownPoint::without}});
}();

template <>
inline constexpr auto fields<report::ShownRecord> = [] {
  using report::ShownRecord;
  return std::tuple{
      Field{"file", [](const ShownRecord& now) { return now.record.name; }, "", {Numbers::all}},
      Field{"scale", [](const ShownRecord& now) { return now.record.scale; }, "", {Numbers::all}},
      Field{"units", [](const ShownRecord& now) { return now.record.units; },
            "of the values in the file"},
      Field{"units_assumed", [](const ShownRecord& now) { return now.record.assumed_g; },
            "whether neither the file nor an option gives them"},
      Field{"pga", [](const ShownRecord& now) { return design::peak_load(now.record); },
            "the largest |W| in g, scaled"},
      Field{"points", &ShownRecord::points, "", {Numbers::from_one}}};
}();

template <>
inline constexpr auto fields<report::SpectrumInput> = [] {
  using report::SpectrumInput;
  return std::tuple{
      Field{"f", [](const SpectrumInput& now) { return now.request.f; }},
      Field{"delta_m",
            [](const SpectrumInput& now) { return now.request.delta * now.scales.length_m; }},
      Field{"hold", [](const SpectrumInput& now) { return now.request.hold; },
            "null with the paper's notch, like notch_width_m"},
      Field{"notch_width_m",
            [](const SpectrumInput& now) {
              return report::times(now.request.notch_width, now.scales.length_m);
            }},
      Field{"combine", [](const SpectrumInput& now) { return now.request.combine.value(); }},
      Field{"gravity_m_per_s2",
            [](const SpectrumInput& now) { return now.scales.gravity_m_per_s2; }}};
}();

template <>
inline constexpr auto fields<report::SpectrumReport> = [] {
  using namespace report;
  return std::tuple_cat(
      head_fields<SpectrumReport, spectrum_name>, told_fields<SpectrumReport>,
      std::tuple{Field{"input",
                       [](const SpectrumReport& report) {
                         return SpectrumInput{report.result.request, report.physical.scales};
                       }},
                 Field{"combined",
                       [](const SpectrumReport& report) {
                         return points_of(report, report.result.combined);
                       },
                       "an entry for each period",
                       {Numbers::from_one}},
                 Field{"records", &records_of, "", {Numbers::from_one}}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

namespace {

/// Calls `use` with the name and the value of each column of a row but the record's.
template <class Use>
void for_each_column(const ShownPoint& point, const Use& use) {
  for_each_field(fields<ShownPoint>, [&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.get), ShownFigures ShownPoint::*>) {
      for_each_field(fields<ShownFigures>, [&](const auto& figure) {
        use(std::string(figure.name) + "_without_notch",
            std::optional<double>(std::invoke(figure.get, std::invoke(field.get, point))));
      });
    } else {
      use(std::string(field.name), std::optional<double>(std::invoke(field.get, point)));
    }
  });
}

/// Empty where a value does not exist.
using SpectrumRow = std::vector<std::optional<double>>;

std::vector<std::string> columns() {
  const design::SpectrumFigures none;
  const design::Scales scales;
  std::vector<std::string> names{"record"};
  for_each_column({{none, scales}, 0, {none, scales}},
                  [&](std::string name, const auto&) { names.push_back(std::move(name)); });
  return names;
}

template <class Write>
void for_each_row(const SpectrumReport& report, const Write& write) {
  double number = 0;
  for (const std::vector<design::SpectrumPoint>& record : report.result.records) {
    ++number;
    for (const ShownPoint& point : points_of(report, record)) {
      SpectrumRow row{number};
      for_each_column(point, [&](const auto&, const auto& value) { row.push_back(value); });
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
  return object_json(report);
}

nlohmann::ordered_json spectrum_schema() {
  return document_schema(spectrum_name.front(), "spectrum --json", "In metres, seconds and g",
                         schema_of<SpectrumReport>());
}

}  // namespace stillpoint::report
