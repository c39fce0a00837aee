// SPDX-License-Identifier: MIT
#include "kernel/linear_piece.hpp"
#include "motion.hpp"

// Turns and arrivals on intervals as short as those between samples, docs/forced.md (F31), (F32),
// against the general formulas in extended precision.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(linear_piece_test)

using Wide = long double;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Of a sum of three products, relative to the largest of them.
constexpr double sum_tolerance = 4 * epsilon;
/// Of a time relative to the piece, in ulp of what the piece is known to: (F25).
constexpr double time_tolerance = 16 * epsilon;

struct Piece {
  double y;
  double v;
  double a;
  double rate;

  template <class Real>
  [[nodiscard]] LinearPiece<Real> as() const {
    return {{Real(y), Real(v), Real(a)}, Real(rate)};
  }
};

/// |v h| and so on: what the terms of (F16) are made of.
double size(const Piece& piece, double h) {
  return std::abs(piece.v) + (std::abs(piece.a) + std::abs(piece.rate)) * h;
}

BOOST_AUTO_TEST_CASE(terms_by_the_half_tangent_have_all_their_digits) {
  Dice dice(921);
  for (int i = 0; i < 2000; ++i) {
    const double t =
        LinearTerms<double>::largest_half_tangent * (i == 0 ? 1 : dice.power_of_ten(-4, 0));
    const auto terms = LinearTerms<double>::of_half_tangent(t);
    const LinearTerms<Wide> exact(2 * std::atan(Wide(t)));
    BOOST_TEST(std::abs(double(terms.sine / exact.sine - 1)) <= sum_tolerance);
    BOOST_TEST(std::abs(double(terms.versine / exact.versine - 1)) <= sum_tolerance);
    BOOST_TEST(std::abs(double(terms.lag / exact.lag - 1)) <= sum_tolerance);
  }
}

BOOST_AUTO_TEST_CASE(events_within_a_short_interval) {
  Dice dice(922);
  std::array<int, 2> met{};
  for (int i = 0; i < 8000; ++i) {
    const bool arrives = i % 2 == 1;
    const double h = 0.1 * dice.power_of_ten(-3, 0);
    const double v = dice.power_of_ten(-3, 0);
    const Piece piece = arrives ? Piece{-h * v * dice.power_of_ten(-4, 0), v, dice.uniform(-1, 1),
                                        dice.uniform(-1, 1) * v / h}
                                : Piece{dice.uniform(-1, 1), h * v, -dice.power_of_ten(-2, 0),
                                        dice.uniform(-1, 1) / h};
    const auto wanted = arrives ? PieceEvent::arrival : PieceEvent::turn;
    const auto end = piece.as<double>().first_event(h, arrives);
    if (end.event != wanted) {
      continue;
    }
    ++met[arrives ? 1 : 0];
    const auto exact = piece.as<Wide>().first_event(h, arrives);
    BOOST_TEST((exact.event == wanted));
    const double of_v = size(piece, h);
    const double of_y = std::abs(piece.y) + of_v * h;
    const double off = std::abs(double(end.h - exact.h));
    if (arrives) {
      const double slow = std::min(static_cast<double>(exact.at.v), piece.v);
      BOOST_TEST(off * slow <= time_tolerance * of_y);
      BOOST_TEST(std::abs(double(end.at.v - exact.at.v)) * slow <=
                 2 * time_tolerance * of_v * of_v);
    } else {
      BOOST_TEST(off * std::abs(static_cast<double>(exact.at.a)) <= time_tolerance * of_v);
      BOOST_TEST(std::abs(double(end.at.y - exact.at.y)) <= sum_tolerance * of_y);
    }
  }
  BOOST_TEST(met[0] > 1000);
  BOOST_TEST(met[1] > 1000);
}

// a(h) = r cos(from + h): r where a multiple of pi lies between, else at an end.
BOOST_AUTO_TEST_CASE(the_largest_acceleration_is_at_an_end_or_at_a_crest_between) {
  Dice dice(924);
  int crests = 0;
  for (int i = 0; i < 1000; ++i) {
    const double r = dice.power_of_ten(-3, 0);
    const double from = dice.uniform(-pi, pi);
    const double h = dice.uniform(0, 4);
    const double v = dice.uniform(0, 1);
    const bool crest = std::ceil(from / pi) * pi <= from + h;
    const double most =
        crest ? 1 : std::max(std::abs(std::cos(from)), std::abs(std::cos(from + h)));
    const auto piece = Piece{0, v, r * std::cos(from), r * std::sin(from) - v}.as<double>();
    const double found = piece.largest_acceleration({PieceEvent::none, h, piece.at(h)}, 0);
    BOOST_TEST(std::abs(found / r - most) <= sum_tolerance / r);
    crests += crest ? 1 : 0;
  }
  BOOST_TEST(crests > 300);
  BOOST_TEST(crests < 700);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
