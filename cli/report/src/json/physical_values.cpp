// SPDX-License-Identifier: MIT
#include "json/parts.hpp"
#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// The SI values of a report, in the order of its fields. Null for what does not exist, needs a
/// mass that is not known, or is beyond a double.
class Values {
 public:
  explicit Values(const design::PhysicalInput& physical) : physical_(physical) {}

  [[nodiscard]] const design::Scales& scales() const { return physical_.scales; }

  void operator()(const char* name, const std::optional<double>& value,
                  const std::optional<double>& unit = 1) {
    const bool finite = value && unit && std::isfinite(*value * *unit);
    json[name] = finite ? ordered_json(*value * *unit) : nullptr;
  }
  void length(const char* name, const std::optional<double>& value) {
    (*this)(name, value, scales().length_m);
  }
  void time(const char* name, const std::optional<double>& tau) {
    (*this)(name, tau, scales().time_s);
  }
  void speed(const char* name, const std::optional<double>& value) {
    (*this)(name, value, scales().velocity_m_per_s);
  }
  void acceleration(const char* name, const std::optional<double>& value) {
    (*this)(name, value, scales().gravity_m_per_s2);
  }

  void add_scales(const std::optional<double>& velocity_m_per_s) {
    json["length_unit_m"] = scales().length_m;
    json["time_unit_s"] = scales().time_s;
    json["velocity_unit_m_per_s"] = scales().velocity_m_per_s;
    json["gravity_m_per_s2"] = scales().gravity_m_per_s2;
    json["omega_rad_per_s"] = scales().omega_rad_per_s;
    json["period_s"] = physical_.period_s;
    json["natural_frequency_hz"] = scales().omega_rad_per_s / (2 * std::numbers::pi);
    json["mass_kg"] = scales().mass_kg;
    json["stiffness_n_per_m"] = scales().stiffness_n_per_m();
    json["velocity_m_per_s"] = velocity_m_per_s;
  }

  /// The bounds, and what would mend an empty region: null if that input alone cannot.
  void add_region(const design::RegionVerdict& verdict) {
    (*this)("max_displacement_m", physical_.max_displacement_m);
    length("max_displacement_min_m", verdict.region.beta_min);
    length("delta2_m", verdict.region.delta2);
    design::PhysicalInput given = physical_;
    given.by_frequency = false;
    const auto mended = [&](std::string_view field, bool by_stiffness) -> std::optional<double> {
      given.by_stiffness = by_stiffness;
      const auto mend = std::ranges::find(verdict.mends, field, &design::Mend::field);
      return mend == verdict.mends.end() ? std::nullopt
                                         : std::optional(physical_mend(given, *mend)->value);
    };
    (*this)("velocity_mend_m_per_s", mended("v0", false));
    (*this)("period_mend_s", mended("p", false));
    (*this)("stiffness_mend_n_per_m", scales().mass_kg ? mended("p", true) : std::nullopt);
    (*this)("max_displacement_mend_m", mended("beta", false));
    (*this)("delta_max_mend_m", mended("delta_max", false));
  }

  void add_damper(const std::optional<double>& f, const std::optional<double>& delta) {
    (*this)("f", f);
    length("delta_m", delta);
    (*this)("friction_force_n", f ? scales().friction_force_n(*f) : f);
    (*this)("energy_per_passage_j", delta ? scales().energy_per_passage_j(*delta) : delta);
  }

  /// A pulse has no velocity.
  void add_served(const std::optional<design::WorksFor>& served, bool of_pulse) {
    json["works_for_velocity_m_per_s"] = nullptr;
    json["works_for_period_s"] = nullptr;
    if (served) {
      const auto [velocity, period] = physical_works_for(scales(), *served);
      json["works_for_velocity_m_per_s"] = of_pulse ? nullptr : interval_json(velocity);
      json["works_for_period_s"] = interval_json(period);
    }
  }

  /// Of a point that is hit, not pushed by a pulse.
  void add_hits(const design::Problem& problem, const std::optional<double>& f,
                const std::optional<double>& delta) {
    json["hits"] = nullptr;
    if (!f || !delta) {
      return;
    }
    const double speed = scales().velocity_m_per_s;
    json["hits"] = list_json(shown_hits(problem, *f, *delta), [&](const design::Hits& now) {
      return ordered_json{{"from_m_per_s", now.from * speed},
                          {"to_m_per_s", now.to * speed},
                          {"rest_m", metres(physical_, now.rest)}};
    });
  }

  /// The least notch width is that of the worst of ranges.
  void add_practice(const std::optional<design::Practice>& lines,
                    const std::optional<design::Practice>& worst) {
    const design::Practice now = lines.value_or(design::Practice());
    const auto weight = scales().friction_force_n(1);
    (*this)("secant_stiffness_n_per_m", now.secant_stiffness,
            weight ? std::optional(*weight / scales().length_m) : weight);
    (*this)("impulse_at_stop_n_s", now.impulse_at_stop, scales().impulse_n_s(1));
    (*this)("impulse_largest_n_s", now.impulse_largest, scales().impulse_n_s(1));
    (*this)("energy_at_stop_j", now.notch_used, scales().energy_per_passage_j(now.notch_capacity));
    length("notch_width_min_m", worst ? worst->notch_width_min : std::nullopt);
  }

  void add_response(const Response* response) {
    const Response now = response != nullptr ? *response : Response();
    const auto existing = [&](double value) {
      return response != nullptr ? std::optional(value) : std::nullopt;
    };
    length("peak_m", existing(now.peak_amplitude));
    acceleration("peak_acceleration_m_per_s2", existing(now.peak_acceleration));
    acceleration("peak_absolute_acceleration_m_per_s2", existing(now.peak_absolute_acceleration));
    speed("jump_m_per_s", existing(now.jump));
    time("stop_time_s", now.stop_time);
    length("stop_position_m", now.stop_position);
    speed("arrival_speed_m_per_s", now.arrival_speed);
  }

  /// Of a wave; null for a record and where there is none.
  void add_excitation(const Excitation& excitation) {
    std::optional<double> lambda;
    std::visit(
        [&lambda](const auto& kind) {
          if constexpr (requires { kind.lambda; }) {
            lambda = kind.lambda;
          }
        },
        excitation);
    (*this)("excitation_rad_per_s", lambda, 1 / scales().time_s);
    (*this)("excitation_frequency_hz", lambda, 1 / (2 * std::numbers::pi * scales().time_s));
    time("excitation_duration_s", lambda ? duration(excitation) : lambda);
  }

  ordered_json json;

 private:
  const design::PhysicalInput& physical_;
};

Excitation excitation_of(const std::optional<design::Pulse>& pulse) {
  return pulse ? design::excitation(*pulse) : NoExcitation{};
}

}  // namespace

ordered_json physical_json(const DesignReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const design::DesignResult& result = report.result;
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  const design::Found* const finding = result.finding ? &*result.finding : nullptr;
  const auto f = finding != nullptr ? std::optional(finding->point.f) : std::nullopt;
  const auto delta = finding != nullptr ? std::optional(finding->point.delta) : std::nullopt;
  Values values(*report.physical);
  const std::optional<double> v0 = pulse ? result.reduced_v0 : problem.v0;
  values.add_scales(v0 ? std::optional(*v0 * values.scales().velocity_m_per_s) : v0);
  values.add_region(result);
  values.add_damper(f, delta);
  values.add_served(finding != nullptr ? finding->works_for : std::nullopt, pulse.has_value());
  values.add_hits(problem, pulse ? std::nullopt : f, delta);
  const auto practice = finding != nullptr ? finding->practice : std::nullopt;
  values.add_practice(
      practice, told_practice(task_of(report), practice, f.value_or(0), delta.value_or(0)).lines);
  values.add_response(finding != nullptr ? &finding->response : nullptr);
  values.add_excitation(excitation_of(pulse));
  return values.json;
}

ordered_json physical_json(const RegionReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const design::RegionAnswer& answer = report.answer;
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  Values values(*report.physical);
  values.add_scales(pulse ? std::nullopt : std::optional(report.physical->velocity_m_per_s));
  values.add_region(answer);
  values.add_damper(f, delta);
  values.add_served(answer.works_for, pulse.has_value());
  values.add_hits(problem, pulse ? std::nullopt : f, delta);
  values.add_practice(
      answer.practice,
      told_practice(task_of(report), answer.practice, f.value_or(0), delta.value_or(0)).lines);
  values.length("delta1_published_m", answer.delta1_published);
  values.length("delta1_exact_m", answer.delta1_exact);
  values.add_excitation(excitation_of(pulse));
  return values.json;
}

ordered_json physical_json(const MotionReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const auto& [p, f, delta, hold] = report.request.oscillator;
  Values values(*report.physical);
  values.add_scales(report.physical->velocity_m_per_s);
  values.add_damper(f, delta);
  values.add_response(&report.answer.response);
  values.add_practice(practice_of(report), {});
  values("caught_impulse_n_s", caught_impulse(report), values.scales().impulse_n_s(1));
  values.add_excitation(report.request.excitation);
  if (report.answer.forced) {
    const ForcedResponse& forced = *report.answer.forced;
    values.time("end_time_s", forced.end_time);
    values.length("final_position_m", forced.final_position);
    values.speed("final_velocity_m_per_s", forced.final_velocity);
    values.time("stick_time_s", forced.stick_time);
    values.time("locked_from_s", forced.locked_from);
    values.acceleration("largest_load_while_locked_m_per_s2", forced.largest_load_while_locked);
  }
  return values.json;
}

}  // namespace stillpoint::report
