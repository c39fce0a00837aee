// SPDX-License-Identifier: MIT
#include "json/asked_fields.hpp"
#include "json/head_fields.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/sweep/npy.hpp>

#include <fmt/format.h>

#include <bit>
#include <limits>

namespace stillpoint {

template <>
inline constexpr auto fields<design::Figures> = [] {
  using Now = design::Figures;
  return std::tuple{Field{"peak_m", &Now::peak, "", si_always(Dimension::length)},
                    Field{"residual_m", &Now::residual,
                          "null where the mass does not come to rest within 10 000 half-cycles",
                          si_always(Dimension::length)},
                    Field{transmitted_name, &Now::acceleration, "in g"}};
}();

template <>
inline constexpr auto fields<design::SpectrumPoint> = [] {
  using Now = design::SpectrumPoint;
  using design::Figures;
  return std::tuple_cat(
      std::tuple{Field{"period_s", [](const Now& now) { return turn(now.p); }, "",
                       si_always(Dimension::time)}},
      fields_in(&Now::with_notch, fields<Figures>),
      fields_in(
          &Now::with_notch,
          std::tuple{Field{"jump_m_per_s", &Figures::jump, "", si_always(Dimension::velocity)},
                     Field{"locked_from_s", &Figures::locked,
                           "null where the mass does not lock, like the next; for several records "
                           "the earliest and the largest",
                           si_always(Dimension::time)},
                     Field{"largest_load_while_locked", &Figures::largest_load_while_locked}}),
      std::tuple{Field{"without_notch", &Now::without}});
}();

template <>
inline constexpr auto fields<design::SpectrumRequest> = [] {
  using Now = design::SpectrumRequest;
  constexpr auto of_damper = [](auto member) { return in(&Now::damper, member); };
  return std::tuple_cat(
      std::tuple{Field{"f", of_damper(&Oscillator::f)},
                 Field{"delta_m", of_damper(&Oscillator::delta), "", si_always(Dimension::length)},
                 Field{"hold", of_damper(&Oscillator::hold),
                       "null with the paper's notch, like notch_width_m"},
                 Field{"notch_width_m", &Now::notch_width, "", si_always(Dimension::length)},
                 Field{"combine", [](const Now& now) { return now.load.combine.value(); }},
                 Field{"gravity_m_per_s2", [](const Now& /*now*/) { return 1.0; }, "",
                       si_always(Dimension::gravities)}},
      fields_in(&Now::damper, beyond_the_paper));
}();

}  // namespace stillpoint

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

constexpr auto spectrum_name = std::to_array<std::string_view>({"stillpoint/spectrum-report/1"});

struct ShownCurve : design::CaseMotion {
  std::optional<double> v0;
  const design::SuiteRecord* record;
  std::vector<design::SpectrumPoint> points;

  using Now = ShownCurve;
  using Record = design::SuiteRecord;
  static constexpr std::tuple field_table{
      Field{"what", &Now::name, "hit, the shape of the pulse, or the file of the record",
            any_number},
      Field{"velocity_m_per_s", &Now::v0, "of a hit", si_always(Dimension::velocity)},
      Field{"k", in(&Now::pulse, k_of), "of a pulse in g, like the next"},
      Field{"duration_s",
            in(&Now::pulse,
               [](const design::Pulse& pulse) { return *duration(design::excitation(pulse)); }),
            "", si_always(Dimension::time)},
      Field{"scale", in(&Now::record, &Record::scale), "of a record, like the next", any_number},
      Field{"units", in(&Now::record, &Record::units), "of the values in the file"},
      Field{"units_assumed", in(&Now::record, &Record::assumed_g),
            "whether neither the file nor an option gives them"},
      Field{"pga", in(&Now::record, [](const Record& of) { return design::peak_load(of); }),
            "the largest |W| in g, scaled"},
      Field{"points", &Now::points, "", at_least_one}};
};

std::vector<ShownCurve> motions_of(const SpectrumReport& report) {
  const design::LoadCase& load = report.result.request.load;
  std::vector<ShownCurve> shown;
  for (design::CaseMotion& motion : design::motions_of(load)) {
    const std::size_t i = shown.size();
    shown.push_back({std::move(motion), load.v0, load.of_records() ? &load.records[i] : nullptr,
                     report.result.motions[i]});
  }
  return shown;
}

constexpr auto spectrum_table = [] {
  using Now = SpectrumReport;
  using design::Spectrum;
  return std::tuple_cat(head_fields<Now, spectrum_name>, told_fields<Now>,
                        std::tuple{Field{"input", in(&Now::result, &Spectrum::request)},
                                   Field{"combined", in(&Now::result, &Spectrum::combined),
                                         "an entry for each period", at_least_one},
                                   Field{"motions", &motions_of, "", at_least_one}});
}();

/// The number of the motion and the columns of a point: those of a motion within have its name
/// behind theirs.
std::vector<ordered_json> rows_of(const SpectrumReport& report) {
  std::vector<ordered_json> rows;
  for (std::size_t i = 0; i < report.result.motions.size(); ++i) {
    for (const design::SpectrumPoint& point : report.result.motions[i]) {
      ordered_json row{{"motion", i + 1}};
      row.update(object_json(point, &report.physical.scales));
      const ordered_json without = row.at("without_notch");
      row.erase("without_notch");
      for (const auto& [name, value] : without.items()) {
        row[name + "_without_notch"] = value;
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace

std::string spectrum_rows(const SpectrumReport& report, bool npy) {
  const std::vector<ordered_json> rows = rows_of(report);
  std::string names;
  std::string cells;
  for (const ordered_json& row : rows) {
    names.clear();
    for (const auto& [name, value] : row.items()) {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      const double number = value.is_null() ? none : value.get<double>();
      names += npy ? sweep::npy_number(name) : name + ",";
      if (npy) {
        const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(number);
        cells.append(bytes.data(), bytes.size());
      } else {
        cells += value.is_null() ? "," : fmt::format("{},", number);
      }
    }
    if (!npy) {
      names.back() = cells.back() = '\n';
    }
  }
  return (npy ? sweep::npy_header(names, std::ssize(rows)) : names) + cells;
}

nlohmann::ordered_json json(const SpectrumReport& report) {
  return object_by<spectrum_table>(report, &report.physical.scales);
}

nlohmann::ordered_json spectrum_schema() {
  return report_schema<SpectrumReport>(spectrum_table, spectrum_name.front(), "spectrum --json",
                                       "In metres, seconds and g");
}

}  // namespace stillpoint::report
