// SPDX-License-Identifier: MIT
#include "kernel/damped_harmonic_piece.hpp"
#include "motion.hpp"
#include "testing/exact.hpp"

// Sliding pieces with damping under a sine, docs/damping.md, alone: against the closed form in 50
// digits, which divides by the distance from resonance, and against dense scans.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(damped_harmonic_test)

constexpr double epsilon = 0x1p-52;
// Of the sizes of the terms of a state.
constexpr double state_tolerance = 8 * epsilon;
// Of a maximum, which is stationary.
constexpr double crest_tolerance = 16 * epsilon;
constexpr int scan = 400;

using Point = HarmonicPoint<double>;

struct Scene {
  Point start;
  double r;
  double zeta;

  template <class Real>
  [[nodiscard]] DampedHarmonicPiece<Real> as(TippingMargin<Real>& margin) const {
    const Point& s = start;
    return {{Real(s.y), Real(s.v), Real(s.a), Real(s.w), Real(s.q)}, Real(r), Real(zeta), margin};
  }
  [[nodiscard]] double longest() const { return 1 / std::max(1.0, r); }
};

/// By a sinusoid and the free motion that is left.
HarmonicPoint<Exact> closed_form(const Scene& scene, const Exact& h) {
  const Exact r = scene.r;
  const Exact zeta = scene.zeta;
  const Exact y0 = scene.start.y;
  const Exact v0 = scene.start.v;
  const Exact a0 = scene.start.a;
  const Exact w0 = scene.start.w;
  const Exact q0 = scene.start.q;
  // v = alpha cos r h + beta sin r h + ...
  const Exact detuning = 1 - r * r;
  const Exact damping = 2 * zeta * r;
  const Exact square = detuning * detuning + damping * damping;
  const Exact alpha = (-detuning * r * q0 - damping * r * w0) / square;
  const Exact beta = (detuning * r * w0 - damping * r * q0) / square;
  const Exact omega = sqrt(Exact(1 - zeta * zeta));
  const Exact sine = exp(Exact(-zeta * h)) * sin(Exact(omega * h)) / omega;
  const Exact cosine = exp(Exact(-zeta * h)) * cos(Exact(omega * h)) + zeta * sine;
  const Exact free_v = v0 - alpha;
  const Exact free_a = a0 - r * beta;
  const Exact c = cos(Exact(r * h));
  const Exact s = sin(Exact(r * h));
  const Exact v = alpha * c + beta * s + free_v * cosine + free_a * sine;
  const Exact a =
      r * (beta * c - alpha * s) + free_a * cosine - (free_v + 2 * zeta * free_a) * sine;
  const Exact w = w0 * c + q0 * s;
  return {y0 + (a0 - a) + (w0 - w) + 2 * zeta * (v0 - v), v, a, w, q0 * c - w0 * s};
}

/// On a slide, near resonance and far from it; a third are released, and turn back, or nearly so.
Scene random_scene(Dice& dice) {
  const double k = dice.power_of_ten(-2, 1);
  const double psi = dice.uniform(-pi, pi);
  const double r = dice.once_in(3) ? 1 + dice.uniform(-1, 1) * dice.power_of_ten(-12, -1)
                                   : dice.power_of_ten(-2, 2);
  const double zeta = dice.once_in(3) ? dice.uniform(0, 0.99) : dice.power_of_ten(-12, -1);
  const double near = dice.power_of_ten(-4, 0);
  Point start{dice.uniform(-2, 1), near, dice.uniform(-2, 2), k * std::sin(psi), k * std::cos(psi)};
  if (dice.once_in(3)) {
    start.v = 0;
    start.a = dice.once_in(2) ? 0 : near;
    start.q = -std::abs(start.q);
  }
  return {start, r, zeta};
}

template <class Action>
void for_scenes(std::uint64_t seed, int count, Action action) {
  Dice dice(seed);
  for (int i = 0; i < count; ++i) {
    action(random_scene(dice), dice);
  }
}

BOOST_AUTO_TEST_CASE(states_are_those_of_the_closed_form) {
  for_scenes(931, 4000, [](const Scene& scene, Dice& dice) {
    TippingMargin<double> margin;
    TippingMargin<Exact> exact_margin;
    const double h = scene.longest() * dice.power_of_ten(-3, 0);
    const Point& s = scene.start;
    const Point at = scene.as<double>(margin).at(h);
    const auto wide = scene.as<Exact>(exact_margin).at(Exact(h));
    const auto exact = closed_form(scene, Exact(h));
    const double load = (std::abs(s.w) + std::abs(s.q)) * scene.r * h;
    const double v = s.v + (std::abs(s.a) + load) * h;
    BOOST_TEST(std::abs(double(wide.v - exact.v)) <= 1e-20 * v);
    BOOST_TEST(std::abs(double(wide.y - exact.y)) <= 1e-20 * (1 + v));
    BOOST_TEST(std::abs(double(at.v - exact.v)) <= state_tolerance * v);
    BOOST_TEST(std::abs(double(at.y - exact.y)) <= state_tolerance * (std::abs(s.y) + v * h));
    BOOST_TEST(std::abs(double(at.a - exact.a)) <= state_tolerance * (std::abs(s.a) + load + v));
    BOOST_TEST(std::abs(double(at.w - exact.w)) <= state_tolerance * (std::abs(s.w) + load));
    BOOST_TEST(std::abs(double(at.q - exact.q)) <= state_tolerance * (std::abs(s.q) + load));
  });
}

// Released as the load passes friction, v begins like h^2, at a crest like h^3.
BOOST_AUTO_TEST_CASE(a_slip_from_rest_keeps_its_digits) {
  for (const double zeta : {1e-12, 0.05, 0.9}) {
    for (const double q : {-0.5, 0.0}) {
      for (const double h : {1e-6, 1e-3, 0.1, 0.9}) {
        const Scene scene{{0.3, 0, 0, 1, q}, 1, zeta};
        TippingMargin<double> margin;
        const Point at = scene.as<double>(margin).at(h);
        const auto exact = closed_form(scene, Exact(h));
        BOOST_TEST(std::abs(double(at.v / exact.v - 1)) <= state_tolerance);
        BOOST_TEST(std::abs(double(at.a / exact.a - 1)) <= state_tolerance);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(no_event_is_missed) {
  int turns = 0;
  int arrivals = 0;
  for_scenes(932, 6000, [&](const Scene& scene, Dice& dice) {
    TippingMargin<double> margin;
    const auto piece = scene.as<double>(margin);
    const bool wanted = scene.start.y < 0;
    const double limit = scene.longest() * (dice.once_in(2) ? 2 : dice.uniform(0, 1));
    const auto end = piece.first_event(limit, wanted);
    BOOST_TEST(end.h > 0);
    BOOST_TEST(end.h <= limit);
    const double size = piece.start().v + std::abs(piece.start().a) + std::abs(end.at.a);
    for (int i = 1; i < scan; ++i) {
      const Point at = piece.at(end.h * i / scan);
      BOOST_TEST(at.v >= 0);
      BOOST_TEST(!(wanted && at.y > 0));
    }
    if (end.event == PieceEvent::none) {
      BOOST_TEST(end.h == std::min(limit, scene.longest()));
      return;
    }
    const bool arrives = end.event == PieceEvent::arrival;
    (arrives ? arrivals : turns) += 1;
    // The residual there in 50 digits, over the slope: (F25) of docs/forced.md.
    const auto exact = closed_form(scene, Exact(end.h));
    const double residual = std::abs(static_cast<double>(arrives ? exact.y : exact.v));
    const auto slope = static_cast<double>(arrives ? exact.v : exact.a);
    const double load = std::abs(scene.start.w) + std::abs(scene.start.q);
    const double terms = arrives ? std::abs(scene.start.y) + size * end.h
                                 : size * end.h + load * scene.r * end.h * end.h;
    BOOST_TEST(residual <= 16 * epsilon * (terms + piece.start().v + std::abs(slope) * end.h));
  });
  BOOST_TEST(turns > 600);
  BOOST_TEST(arrivals > 200);
}

// v dips to its smallest value in the middle of the piece.
BOOST_AUTO_TEST_CASE(a_dip_is_a_turn_only_where_v_falls_below_0) {
  for_scenes(934, 2000, [](Scene scene, Dice& dice) {
    const double q = -dice.power_of_ten(-2, 1);
    const double least = dice.sign() * dice.power_of_ten(-12, -4) * scene.r * -q;
    const double h = scene.longest() * dice.uniform(0.1, 0.4);
    scene.start = {scene.start.y, least, 0, 0, q};
    const auto exact = closed_form(scene, Exact(-h));
    scene.start = {double(exact.y), double(exact.v), double(exact.a), double(exact.w),
                   double(exact.q)};
    TippingMargin<double> margin;
    const auto end = scene.as<double>(margin).first_event(2 * h, false);
    if (!(scene.start.v > 1e-2 * scene.r * h * h * -q)) {
      return;  // it has not come from above
    }
    BOOST_TEST((end.event == PieceEvent::turn) == (least < 0));
    if (least > 0) {
      BOOST_TEST(margin.any());
      BOOST_TEST(margin.slack() <= 1.01 * least + 1e-13 * scene.r * -q);
      BOOST_TEST(margin.slack() >= 0.5 * least);
    }
  });
}

BOOST_AUTO_TEST_CASE(the_largest_accelerations_are_those_of_a_scan) {
  int crests = 0;
  for_scenes(933, 3000, [&](const Scene& scene, Dice& /*dice*/) {
    TippingMargin<double> margin;
    const auto piece = scene.as<double>(margin);
    const auto end = piece.first_event(scene.longest(), false);
    const double acceleration = piece.largest_acceleration(end, 0);
    const Point& s = scene.start;
    const double phi = -(s.a + s.w + s.y + 2 * scene.zeta * s.v);
    const double transmitted = piece.largest_transmitted(phi, end, 0);
    double most = 0;
    double felt = 0;
    for (int i = 0; i <= scan; ++i) {
      const Point at = piece.at(end.h * i / scan);
      most = std::max(most, std::abs(at.a));
      felt = std::max(felt, std::abs(at.a + at.w));
    }
    const double load = std::abs(s.w) + std::abs(s.q);
    const double rounding = crest_tolerance * (1 + scene.r) * (most + load + s.v + std::abs(s.y));
    const double between = 1e-5 * (1 + scene.r) * (1 + 1 / scene.r);
    BOOST_TEST(acceleration >= most - rounding);
    BOOST_TEST(transmitted >= felt - rounding);
    BOOST_TEST(acceleration <= most * (1 + between) + rounding);
    BOOST_TEST(transmitted <= felt * (1 + between) + rounding);
    const double at_ends =
        std::max(std::abs(scene.start.a + scene.start.w), std::abs(end.at.a + end.at.w));
    crests += transmitted > at_ends * (1 + 1e-9) ? 1 : 0;
  });
  BOOST_TEST(crests > 100);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
