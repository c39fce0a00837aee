// SPDX-License-Identifier: MIT
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(shock_spectrum_test)

using namespace stillpoint::design_test;

// The spectra of pulses and hits, whose closed forms are a page of any book on shocks. p/lambda is
// twice the length of the pulse over the period; the full sine is twice as long.

/// Of closed forms: some roundings of sines.
constexpr double closed_form_tolerance = 1e-13;

constexpr double pi = std::numbers::pi;

SpectrumRequest request_of(LoadCase load, std::vector<double> p, double f = 0, double delta = 0,
                           double zeta = 0) {
  SpectrumRequest request;
  request.load = std::move(load);
  request.p = std::move(p);
  request.damper.f = f;
  request.damper.delta = delta;
  request.damper.zeta = zeta;
  return request;
}

void check_close(double value, double truth) {
  BOOST_TEST(std::abs(value - truth) <= closed_form_tolerance * truth, value << " " << truth);
}

/// p^2/k times the peak of a mass without a damper under sin(lambda tau), r = p/lambda. It turns at
/// lambda tau = 2 pi n/(r + 1) during the pulse, where x = k sin(lambda tau)/(p (p - lambda)), and
/// swings by 2 r cos(r pi/2)/(1 - r^2) after it.
double half_sine_ratio(double r) {
  double most = std::abs(2 * r * std::cos(r * pi / 2) / (1 - r * r));
  for (int n = 1; 2 * n <= r + 1; ++n) {
    most = std::max(most, r / (r - 1) * std::sin(2 * pi * n / (r + 1)));
  }
  return most;
}

BOOST_AUTO_TEST_CASE(a_half_sine_shocks_a_bare_mass_as_in_the_books) {
  constexpr double k = 0.3;
  constexpr double lambda = 1.7;
  std::vector<double> p;
  for (int i = 1; i <= 400; ++i) {
    p.push_back(lambda * (0.0123 + 0.02 * i));
  }
  const Spectrum found = spectrum(request_of({.pulse = HalfSine{k, lambda}}, p));
  const SpectrumPoint* worst = &found.combined.front();
  for (const SpectrumPoint& point : found.combined) {
    const double ratio = half_sine_ratio(point.p / lambda);
    check_close(point.without.acceleration, k * ratio);
    check_close(point.without.peak, k * ratio / (point.p * point.p));
    worst = point.without.acceleration > worst->without.acceleration ? &point : worst;
  }
  // The known amplification, with a pulse 0.81 of the period long: r/(r - 1) sin(2 pi/(r + 1)) is
  // 1.76846 at its largest, at r = 1.6199.
  BOOST_TEST(std::abs(worst->without.acceleration / k - 1.76846) <= 5e-5);
  BOOST_TEST(std::abs(worst->p / lambda - 1.6199) <= 0.02);
}

// From half a period on a rectangle is a step to it, with the peak 2 k/p^2.
BOOST_AUTO_TEST_CASE(a_rectangle_doubles_from_half_a_period_on) {
  const Spectrum found = spectrum(
      request_of({.pulse = Rectangle{0.2, 0.9}}, {0.1, 0.45, 0.8, 0.9 * (1 + 1e-9), 1, 3, 80}));
  for (const auto& [with, without, p] : found.combined) {
    const double ratio = p >= 0.9 ? 2 : 2 * std::sin(pi * p / (2 * 0.9));
    check_close(without.acceleration, 0.2 * ratio);
    check_close(without.peak, 0.2 * ratio / (p * p));
  }
}

// p times the peak, the pseudo-velocity, is the velocity of the hit. Friction takes f times the
// peak of its energy: v0^2 = p^2 x^2 + 2 f x.
BOOST_AUTO_TEST_CASE(a_hit_has_one_pseudo_velocity) {
  const std::vector<double> p{1e-3, 0.3, 1, 17, 1e4};
  for (const double f : {0.0, 0.05, 0.7}) {
    const Spectrum found = spectrum(request_of({.v0 = 0.8}, p, f));
    BOOST_TEST(found.findings.empty());
    for (const auto& [with, without, now] : found.combined) {
      const double felt = std::hypot(f, 0.8 * now);
      check_close(without.acceleration, felt);
      check_close(without.peak, 0.8 * 0.8 / (felt + f));
      BOOST_TEST(with.peak == without.peak);
    }
  }
}

/// How far a damped mass swings beyond the middle of a step, as a share.
double overshoot(double zeta) {
  return std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
}

BOOST_AUTO_TEST_CASE(damping_takes_its_share_of_a_step_and_of_a_hit) {
  for (const double zeta : {0.01, 0.05, 0.3, 0.9}) {
    // Half a damped period is over before the end of the pulse: pi/0.2 > pi/(p sqrt(1 - zeta^2)).
    const std::vector<double> p{0.5, 1, 4};
    for (const double f : {0.0, 0.1}) {
      const Spectrum step = spectrum(request_of({.pulse = Rectangle{0.4, 0.2}}, p, f, 0, zeta));
      for (const SpectrumPoint& point : step.combined) {
        check_close(point.without.peak, (0.4 - f) * (1 + overshoot(zeta)) / (point.p * point.p));
      }
    }
    // Of a hit the mass turns where tan(p' tau) = p'/(zeta p), with p' = p sqrt(1 - zeta^2).
    const Spectrum hit = spectrum(request_of({.v0 = 2}, p, 0, 0, zeta));
    const double slow = std::sqrt(1 - zeta * zeta);
    for (const SpectrumPoint& point : hit.combined) {
      check_close(point.without.peak,
                  2 / point.p * std::exp(-zeta / slow * std::atan2(slow, zeta)));
    }
  }
}

/// The load of the pulse from step to step, whose last value is at its end.
SuiteRecord sampled(const Pulse& pulse, int steps) {
  const double length = *duration(excitation(pulse));
  Record record{{}, length / steps, {}};
  for (int i = 0; i <= steps; ++i) {
    const double tau = i * record.step;
    record.values.push_back(
        std::visit([&](const auto& kind) { return load_at(kind, tau); }, pulse));
  }
  return {"sampled", record, 1};
}

/// The largest difference; all figures are of the order of 1, or 0 where a wide notch holds the
/// mass.
double apart(const Figures& one, const Figures& other) {
  const auto rest = [](const Figures& of) { return of.residual.value_or(0); };
  return std::max({std::abs(one.peak - other.peak), std::abs(one.acceleration - other.acceleration),
                   std::abs(one.jump - other.jump), std::abs(rest(one) - rest(other))});
}

// Between samples a record is straight, as a trapezoid is in tenths: they are one load, whatever
// the damper. Of a half-sine n samples miss at most k (pi/n)^2/8.
BOOST_AUTO_TEST_CASE(a_record_that_samples_a_pulse_has_its_spectrum) {
  RandomSource random(2411);
  for (int i = 0; i < 40; ++i) {
    const double k = random.uniform(0.2, 1);
    const double lambda = random.uniform(0.3, 3);
    SpectrumRequest pulse =
        request_of({.pulse = Trapezoid{k, lambda}}, {random.uniform(0.5, 3)},
                   random.uniform(0.01, 0.15), random.uniform(0.001, 0.05), random.uniform(0, 0.2));
    random.one_in(3, pulse.damper.hold, [&] { return random.uniform(0, 0.2); });
    if (!pulse.damper.hold) {
      random.one_in(2, pulse.notch_width, [&] { return random.uniform(0.05, 0.2); });
    }
    SpectrumRequest record = pulse;
    record.load = {.records = {sampled(Trapezoid{k, lambda}, 10)}};
    for (const auto member : {&SpectrumPoint::with_notch, &SpectrumPoint::without}) {
      BOOST_TEST(apart(spectrum(record).combined[0].*member, spectrum(pulse).combined[0].*member) <=
                 1e-9);
    }
    pulse.load.pulse = HalfSine{k, lambda};
    record.load.records = {sampled(HalfSine{k, lambda}, 2000)};
    const Figures of_pulse = spectrum(pulse).combined[0].without;
    const Figures of_record = spectrum(record).combined[0].without;
    BOOST_TEST(std::abs(of_record.peak / of_pulse.peak - 1) <= 1e-5);
    BOOST_TEST(std::abs(of_record.acceleration / of_pulse.acceleration - 1) <= 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_hit_with_a_notch_is_the_free_motion) {
  const SpectrumRequest request = request_of({.v0 = 1}, {0.7, 1, 2.2}, 0.05, 0.02);
  const Spectrum found = spectrum(request);
  for (const SpectrumPoint& point : found.combined) {
    const Response motion = free_response({point.p, 0.05, 0.02}, {0, 1});
    check_close(point.with_notch.peak, motion.peak_amplitude);
    check_close(point.with_notch.acceleration, motion.peak_absolute_acceleration);
    BOOST_TEST(std::abs(*point.with_notch.residual - std::abs(*motion.stop_position)) <= 1e-12);
  }
}

// A notch without a width takes a hit of v0^2/2 <= delta; the structure feels it in full.
BOOST_AUTO_TEST_CASE(a_hit_that_the_notch_catches_is_told) {
  const auto caught = [](double v0, const std::optional<double>& width) {
    SpectrumRequest request = request_of({.v0 = v0}, {1, 2}, 0.05, 0.02);
    request.notch_width = width;
    const std::vector<Finding> all = spectrum(request).findings;
    return std::ranges::find(all, FindingKind::catches_hit, &Finding::kind) != all.end();
  };
  BOOST_TEST(caught(0.199, {}));
  BOOST_TEST(!caught(0.201, {}));
  BOOST_TEST(!caught(0.199, 0.1));
}

BOOST_AUTO_TEST_CASE(wrong_loads_are_refused) {
  const auto refused = [](const std::string& field, LoadCase load, double p = 1) {
    test::check_refused(field, [&] { return spectrum(request_of(std::move(load), {1, p})); });
  };
  refused("v0", {.v0 = 0});
  refused("k", {.pulse = HalfSine{0, 1}});
  refused("lambda", {.pulse = HalfSine{1, 0}});
  refused("p", {.pulse = HalfSine{1, 1}}, 1.01e4);  // too many swings under the pulse
}

BOOST_AUTO_TEST_SUITE_END()
