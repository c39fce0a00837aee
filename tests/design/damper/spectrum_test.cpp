// SPDX-License-Identifier: MIT
#include "check/runge_kutta.hpp"
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(spectrum_test)

using namespace stillpoint::design_test;

/// Of closed forms: some roundings of sines.
constexpr double closed_form_tolerance = 1e-13;

/// 0.4 g for two units of time, then nothing.
SuiteRecord rectangle(double scale = 1) {
  return {"rectangle", Record{{0.4, 0.4}, 2, {}}, scale};
}

/// Some shaking that returns often, W in g.
SuiteRecord shaking() {
  return short_records().cases.front().records.front();
}

SpectrumRequest request_of(std::vector<SuiteRecord> records, double f, double delta) {
  SpectrumRequest request;
  request.load.records = std::move(records);
  request.p = {0.4, 1, 1.5};
  request.damper.f = f;
  request.damper.delta = delta;
  return request;
}

bool same(const Figures& one, const Figures& other) {
  return one.peak == other.peak && one.acceleration == other.acceleration &&
         one.jump == other.jump && one.residual == other.residual;
}

BOOST_AUTO_TEST_CASE(a_friction_that_takes_too_long_has_the_peak_but_no_residual) {
  const Spectrum none = spectrum(request_of({rectangle()}, 0, 0));
  for (const auto& [f, delta] :
       {std::pair(0.0, 0.0), std::pair(1e-9, 1e-9), std::pair(1e-9, 0.0), std::pair(0.0, 1e-9)}) {
    const Spectrum found = spectrum(request_of({rectangle()}, f, delta));
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

/// Which suite_test compares with an independent integrator.
BOOST_AUTO_TEST_CASE(each_point_is_a_motion_of_the_kernel) {
  RandomSource random(2203);
  for (int i = 0; i < 30; ++i) {
    SpectrumRequest request =
        request_of({shaking()}, random.uniform(0.01, 0.1), random.uniform(0.001, 0.05));
    request.p = {random.uniform(0.5, 2)};
    random.one_in(3, request.damper.hold, [&] { return random.uniform(0, 0.2); });
    if (!request.damper.hold) {
      random.one_in(2, request.notch_width, [&] { return random.uniform(0.01, 0.1); });
    }
    const Record load = scaled(request.load.records[0]);
    const SpectrumPoint point = spectrum(request).motions[0][0];
    const auto figures = [&](const Oscillator& oscillator, const Surface& surface) {
      const ForcedResponse motion = forced_response(oscillator, {}, load, {}, surface);
      return Figures{motion.peak_amplitude, motion.peak_absolute_acceleration, motion.jump,
                     std::abs(motion.stop_position.value())};
    };
    const double p = request.p[0];
    BOOST_TEST(same(point.with_notch,
                    figures({p, request.damper.f, request.damper.delta, request.damper.hold},
                            {request.notch_width, {}})));
    BOOST_TEST(same(point.without, figures({p, request.damper.f, 0}, {})));
  }
}

// Two records, one three times the other, and no friction: everything is in proportion.
BOOST_AUTO_TEST_CASE(the_largest_and_the_mean_of_records) {
  SpectrumRequest request = request_of({rectangle(), rectangle(-3)}, 0, 0);
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
  SpectrumRequest request = request_of({shaking(), rectangle()}, 0.03, 0.02);
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
  SpectrumRequest request = request_of({shaking()}, 0.03, 0.02);
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

BOOST_AUTO_TEST_CASE(wrong_input_is_refused) {
  const auto refused = [](const std::string& field,
                          const std::function<void(SpectrumRequest&)>& spoil) {
    SpectrumRequest request = request_of({rectangle()}, 0.1, 0.01);
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
}

BOOST_AUTO_TEST_SUITE_END()
