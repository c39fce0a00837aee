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

BOOST_AUTO_TEST_CASE(turns_within_a_short_interval) {
  Dice dice(922);
  int turns = 0;
  for (int i = 0; i < 4000; ++i) {
    const double h = 0.1 * dice.power_of_ten(-3, 0);
    const Piece piece{dice.uniform(-1, 1), h * dice.power_of_ten(-3, 0), -dice.power_of_ten(-2, 0),
                      dice.uniform(-1, 1) / h};
    const auto end = piece.as<double>().first_event(h, false);
    if (end.event != PieceEvent::turn) {
      continue;
    }
    ++turns;
    const auto exact = piece.as<Wide>().first_event(h, false);
    BOOST_TEST((exact.event == PieceEvent::turn));
    const double steep = std::abs(static_cast<double>(exact.at.a));
    BOOST_TEST(std::abs(double(end.h - exact.h)) * steep <= time_tolerance * size(piece, h));
    BOOST_TEST(std::abs(double(end.at.y - exact.at.y)) <=
               sum_tolerance * (std::abs(piece.y) + size(piece, h) * h));
  }
  BOOST_TEST(turns > 1000);
}

BOOST_AUTO_TEST_CASE(arrivals_within_a_short_interval) {
  Dice dice(923);
  int arrivals = 0;
  for (int i = 0; i < 4000; ++i) {
    const double h = 0.1 * dice.power_of_ten(-3, 0);
    const double v = dice.power_of_ten(-3, 0);
    const Piece piece{-h * v * dice.power_of_ten(-4, 0), v, dice.uniform(-1, 1),
                      dice.uniform(-1, 1) * v / h};
    const auto end = piece.as<double>().first_event(h, true);
    if (end.event != PieceEvent::arrival) {
      continue;
    }
    ++arrivals;
    const auto exact = piece.as<Wide>().first_event(h, true);
    BOOST_TEST((exact.event == PieceEvent::arrival));
    const double slow = std::min(static_cast<double>(exact.at.v), piece.v);
    BOOST_TEST(std::abs(double(end.h - exact.h)) * slow <=
               time_tolerance * (std::abs(piece.y) + size(piece, h) * h));
    BOOST_TEST(std::abs(double(end.at.v - exact.at.v)) * slow <=
               2 * time_tolerance * size(piece, h) * size(piece, h));
  }
  BOOST_TEST(arrivals > 1000);
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
