// SPDX-License-Identifier: MIT
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(spectrum_test)

using namespace stillpoint::design_test;

// Some closed forms are a page of any book on shocks. p/lambda is twice the length of a half-sine
// over the period.

/// Of closed forms: some roundings of sines.
constexpr double closed_form_tolerance = 1e-13;

constexpr double pi = std::numbers::pi;

/// 0.4 g for two units of time, then nothing.
SuiteRecord rectangle(double scale = 1) {
  return {"rectangle", Record{{0.4, 0.4}, 2, {}}, scale};
}

/// Some shaking that returns often, W in g.
SuiteRecord shaking() {
  return short_records().cases.front().records.front();
}

SpectrumRequest request_of(LoadCase load, double f, double delta,
                           std::vector<double> p = {0.4, 1, 1.5}) {
  SpectrumRequest request;
  request.load = std::move(load);
  request.p = std::move(p);
  request.damper.f = f;
  request.damper.delta = delta;
  return request;
}

void check_close(double value, double truth) {
  BOOST_TEST(std::abs(value - truth) <= closed_form_tolerance * truth, value << " " << truth);
}

bool same(const Figures& one, const Figures& other) {
  return one.peak == other.peak && one.acceleration == other.acceleration &&
         one.jump == other.jump && one.residual == other.residual;
}

BOOST_AUTO_TEST_CASE(a_friction_that_takes_too_long_has_the_peak_but_no_residual) {
  const Spectrum none = spectrum(request_of({.records = {rectangle()}}, 0, 0));
  for (const auto& [f, delta] :
       {std::pair(0.0, 0.0), std::pair(1e-9, 1e-9), std::pair(1e-9, 0.0), std::pair(0.0, 1e-9)}) {
    const Spectrum found = spectrum(request_of({.records = {rectangle()}}, f, delta));
    for (std::size_t i = 0; i < found.request.p.size(); ++i) {
      // Up to the peak friction takes at most 2 f/p^2 of each of two half-cycles, and the notch, of
      // one passage, Delta of v^2/2 = (p x)^2/2: Delta/(p^2 x) of x.
      const double p = found.request.p[i];
      const double peak = none.motions[0][i].with_notch.peak;
      BOOST_TEST(std::abs(found.motions[0][i].with_notch.peak - peak) <=
                 (4e-9 + 1e-9 / peak) / (p * p));
      BOOST_TEST(!found.motions[0][i].with_notch.residual.has_value());
    }
  }
}

/// Which suite_test compares with an independent integrator: under records and pulses and after
/// hits, damped or not.
BOOST_AUTO_TEST_CASE(each_point_is_a_motion_of_the_kernel) {
  RandomSource random(2203);
  for (int i = 0; i < 90; ++i) {
    const std::array loads{
        LoadCase{.records = {shaking()}}, LoadCase{.v0 = random.uniform(0.5, 1)},
        LoadCase{.pulse = HalfSine{random.uniform(0.2, 1), random.uniform(0.3, 3)}}};
    SpectrumRequest request =
        request_of(loads.at(static_cast<std::size_t>(i % 3)), random.uniform(0.01, 0.1),
                   random.uniform(0.001, 0.05), {random.uniform(0.5, 2)});
    random.one_in(2, request.damper.zeta, [&] { return random.uniform(0, 0.5); });
    random.one_in(3, request.damper.hold, [&] { return random.uniform(0, 0.2); });
    if (!request.damper.hold) {
      random.one_in(2, request.notch_width, [&] { return random.uniform(0.01, 0.1); });
    }
    const CaseMotion of = motions_of(request.load).front();
    const SpectrumPoint point = spectrum(request).motions[0][0];
    const auto figures = [&](const Oscillator& oscillator, const Surface& surface) {
      return figures_of(forced_response(oscillator, of.start, of.load, {}, surface));
    };
    Oscillator oscillator = request.damper;
    oscillator.p = request.p.front();
    BOOST_TEST(same(point.with_notch, figures(oscillator, {request.notch_width, {}})));
    oscillator.delta = 0;
    oscillator.hold.reset();
    BOOST_TEST(same(point.without, figures(oscillator, {})));
  }
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
  const Spectrum found = spectrum(request_of({.pulse = HalfSine{k, lambda}}, 0, 0, p));
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

// p times the peak, the pseudo-velocity, is the velocity of the hit. Friction takes f times the
// peak of its energy: v0^2 = p^2 x^2 + 2 f x.
BOOST_AUTO_TEST_CASE(a_hit_has_one_pseudo_velocity) {
  const std::vector<double> p{1e-3, 0.3, 1, 17, 1e4};
  for (const double f : {0.0, 0.05, 0.7}) {
    const Spectrum found = spectrum(request_of({.v0 = 0.8}, f, 0, p));
    BOOST_TEST(found.findings.empty());
    for (const auto& [with, without, now] : found.combined) {
      const double felt = std::hypot(f, 0.8 * now);
      check_close(without.acceleration, felt);
      check_close(without.peak, 0.8 * 0.8 / (felt + f));
      BOOST_TEST(with.peak == without.peak);
    }
  }
}

// Two records, one three times the other, and no friction: everything is in proportion.
BOOST_AUTO_TEST_CASE(the_largest_and_the_mean_of_records) {
  SpectrumRequest request = request_of({.records = {rectangle(), rectangle(-3)}}, 0, 0);
  const Spectrum largest = spectrum(request);
  BOOST_TEST((largest.request.load.combine == Combine::max));
  request.load.combine = Combine::mean;
  const Spectrum mean = spectrum(request);
  for (std::size_t i = 0; i < request.p.size(); ++i) {
    const double one = largest.motions[0][i].without.peak;
    BOOST_TEST(std::abs(largest.combined[i].without.peak - 3 * one) <= closed_form_tolerance * one);
    BOOST_TEST(std::abs(mean.combined[i].without.peak - 2 * one) <= closed_form_tolerance * one);
    BOOST_TEST(!mean.combined[i].without.residual.has_value());
  }
  request.load.combine.reset();
  request.load.records.resize(7, request.load.records.front());
  BOOST_TEST((spectrum(request).request.load.combine == Combine::mean));
}

BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing) {
  SpectrumRequest request = request_of({.records = {shaking(), rectangle()}}, 0.03, 0.02);
  request.damper.hold = 0.1;
  request.threads = 1;
  const Spectrum one = spectrum(request);
  const std::string line = summary(one);
  BOOST_TEST(line.starts_with("Largest of 2 records: the notch lowers the residual at "), line);
  for (const int threads : {2, 3}) {
    request.threads = threads;
    const Spectrum other = spectrum(request);
    for (std::size_t i = 0; i < request.p.size(); ++i) {
      BOOST_TEST(same(one.combined[i].with_notch, other.combined[i].with_notch));
      BOOST_TEST(same(one.motions[1][i].without, other.motions[1][i].without));
    }
  }
}

BOOST_AUTO_TEST_CASE(returning_false_ends_it) {
  SpectrumRequest request = request_of({.records = {shaking()}}, 0.03, 0.02);
  request.threads = 1;
  request.p.assign(50, 1);
  int asked = 0;
  const Spectrum stopped = spectrum(request, [&asked](double done) {
    BOOST_TEST(std::abs(done - asked / 50.0) <= 1e-15);
    return ++asked <= 5;
  });
  BOOST_TEST(asked == 6);
  BOOST_TEST(stopped.motions[0][4].with_notch.peak > 0);
  BOOST_TEST(stopped.motions[0][5].with_notch.peak == 0);
}

// A notch without a width takes a hit of v0^2/2 <= delta; the structure feels it in full.
BOOST_AUTO_TEST_CASE(a_hit_that_the_notch_catches_is_told) {
  const auto caught = [](double v0, const std::optional<double>& width) {
    SpectrumRequest request = request_of({.v0 = v0}, 0.05, 0.02);
    request.notch_width = width;
    const std::vector<Finding> all = spectrum(request).findings;
    return std::ranges::find(all, FindingKind::catches_hit, &Finding::kind) != all.end();
  };
  BOOST_TEST(caught(0.199, {}));
  BOOST_TEST(!caught(0.201, {}));
  BOOST_TEST(!caught(0.199, 0.1));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused) {
  const auto refused = [](const std::string& field,
                          const std::function<void(SpectrumRequest&)>& spoil) {
    SpectrumRequest request = request_of({.records = {rectangle()}}, 0.1, 0.01);
    spoil(request);
    test::check_refused(field, [&] { return spectrum(request); });
  };
  refused("records", [](auto& request) { request.load.records.clear(); });
  refused("scale", [](auto& request) { request.load.records[0].scale = 0; });
  refused("p", [](auto& request) { request.p.clear(); });
  refused("p", [](auto& request) { request.p[1] = 0; });
  refused("f", [](auto& request) { request.damper.f = -1; });
  refused("delta", [](auto& request) { request.damper.delta = -1; });
  refused("hold", [](auto& request) { request.damper.hold = -1; });
  refused("notch-width", [](auto& request) { request.notch_width = 0; });
  refused("threads", [](auto& request) { request.threads = -1; });
  refused("v0", [](auto& request) { request.load = {.v0 = 0}; });
  refused("k", [](auto& request) { request.load = {.pulse = HalfSine{0, 1}}; });
  refused("lambda", [](auto& request) { request.load = {.pulse = HalfSine{1, 0}}; });
  refused("p", [](auto& request) {  // too many swings under the pulse
    request.load = {.pulse = HalfSine{1, 1}};
    request.p = {1, 1.01e4};
  });
}

BOOST_AUTO_TEST_SUITE_END()
