// SPDX-License-Identifier: MIT
#pragma once

// What a design or a region was asked for, with its table of fields.

#include "json/fields.hpp"

namespace stillpoint::report {

using IfReal = std::optional<double>;
using IfCount = std::optional<std::int64_t>;
using IfRange = std::optional<Interval>;

inline constexpr auto objectives =
    std::to_array<std::string_view>({"robust", "amplitude", "time", "acceleration", "residual"});

inline constexpr auto shape_of = [](const design::Pulse& pulse) { return design::name(pulse); };
inline constexpr auto k_of = [](const design::Pulse& pulse) { return design::peak_load(pulse); };
inline constexpr auto lambda_of = [](const design::Pulse& pulse) {
  return design::angular_frequency(pulse);
};

/// What was asked for.
struct AskedTask {
  IfReal v0{}, p{}, beta{}, residual{}, jump_max{}, f{}, delta{}, hold{}, notch_width{};
  IfRange v0_range{}, p_range{}, tolerance_f{}, tolerance_delta{}, tolerance_width{},
      tolerance_period{}, k_range{}, lambda_range{}, f_range{}, delta_range{}, notch_width_range{};
  IfCount arrivals{}, trade_off{};
  std::optional<design::Criterion> criterion{};
  double tolerance{0};
  design::Limits limits{};
  std::optional<design::Pulse> pulse{};
  std::optional<std::string_view> objective{};
  Name algorithm{}, catalogue{};
  Oscillator mass{};
  double damping_most{0};

  using Now = AskedTask;
  using Limits = design::Limits;
  static constexpr std::tuple own_fields{
      Field{"v0", &Now::v0,
            "of the motion shown; with a pulse, the velocity of its reduction in a design, else "
            "null",
            any_number},
      Field{"v0_range", &Now::v0_range},
      Field{"p", &Now::p, "null under records, like criterion and arrivals"},
      Field{"p_range", &Now::p_range},
      Field{"beta", &Now::beta},
      Field{"criterion", &Now::criterion},
      Field{"arrivals", &Now::arrivals, "", at_least_one},
      Field{"residual", &Now::residual, "", in_metres},
      Field{"tolerance", &Now::tolerance},
      Field{"tolerance_f", &Now::tolerance_f, "factors between which f may lie, like the next"},
      Field{"tolerance_delta", &Now::tolerance_delta},
      Field{"tolerance_width", &Now::tolerance_width},
      Field{"tolerance_period", &Now::tolerance_period},
      Field{"f_max", in(&Now::limits, &Limits::f_max)},
      Field{"delta_max", in(&Now::limits, &Limits::delta_max)},
      Field{"acceleration_max", in(&Now::limits, &Limits::acceleration_max)},
      Field{"jump_max", &Now::jump_max, "", with_si(Dimension::velocity)},
      Field{"pulse", in(&Now::pulse, shape_of), "", one_of(kind_names<design::Pulse>)},
      Field{"k", in(&Now::pulse, k_of)},
      Field{"k_range", &Now::k_range},
      Field{"lambda", in(&Now::pulse, lambda_of)},
      Field{"lambda_range", &Now::lambda_range},
      Field{"f_range", &Now::f_range, "searched under records, like the next two"},
      Field{"delta_range", &Now::delta_range},
      Field{"notch_width_range", &Now::notch_width_range},
      Field{"f", &Now::f, "of a given damper, like delta"},
      Field{"delta", &Now::delta},
      Field{"hold", &Now::hold, "null: any load"},
      Field{"notch_width", &Now::notch_width, "if it is given", in_metres},
      Field{"objective", &Now::objective, "null for a region", one_of(objectives)},
      Field{"algorithm", &Now::algorithm, "as given; null if the program chooses"},
      Field{"catalogue", &Now::catalogue, "the file"},
      Field{"trade_off", &Now::trade_off, "how many"}};
  static constexpr auto field_table =
      std::tuple_cat(own_fields, fields_in(&Now::mass, beyond_the_paper),
                     std::tuple{Field{"damping_most", &Now::damping_most,
                                      "of a range, whose least is the damping", unless(0)}});
};

}  // namespace stillpoint::report
