// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include <bit>

// The elementary functions against 50 digits, and their bits.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(elementary_test)

/// In units in the last place of the result.
double error(double value, const Exact& right) {
  const double size = std::abs(static_cast<double>(right));
  const double place = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(abs(Exact(value) - right) / place);
}

/// The largest error seen.
class Worst {
 public:
  void see(double value, const Exact& right) { worst_ = std::max(worst_, error(value, right)); }
  [[nodiscard]] double value() const { return worst_; }

 private:
  double worst_{0};
};

// What elementary.hpp promises, in units in the last place.
constexpr double sine_error = 0.8;
constexpr double atan2_error = 0.7;
constexpr double inverse_error = 2;
constexpr double exp_error = 0.501;
constexpr double between_error = 0.501;
constexpr double log_error = 0.6;
constexpr double hypot_error = 1.5;

constexpr int cases = 20000;

/// Of both signs and of every size from 10^low to 10^high.
double of_any_size(Dice& dice, double low, double high) {
  return dice.sign() * dice.power_of_ten(low, high);
}

BOOST_AUTO_TEST_CASE(sine_and_cosine) {
  Worst of_sine;
  Worst of_cosine;
  const auto see = [&](double x) {
    const auto at = elementary::sin_cos(x);
    of_sine.see(at.sine, sin(Exact(x)));
    of_cosine.see(at.cosine, cos(Exact(x)));
  };
  Dice dice(1);
  for (int i = 0; i < cases; ++i) {
    see(dice.uniform(-7, 7));
    see(of_any_size(dice, -20, 6));
  }
  for (int i = 1; i <= 32; ++i) {  // at and between the entries of the table
    see(i / 32.0);
  }
  for (int quarter = 1; quarter < 600000; quarter += 1 + quarter / 50) {  // near the zeros
    const double multiple = quarter * (std::numbers::pi / 2);
    see(multiple);
    see(std::nextafter(multiple, 0));
  }
  // The double next to a multiple of pi / 2 below 1e6 relative to its size, by continued fractions.
  see(0x1.6c6cbc45dc8dep+5);
  see(0x1.6c6cbc45dc8dep+19);
  BOOST_TEST(of_sine.value() <= sine_error);
  BOOST_TEST(of_cosine.value() <= sine_error);
}

BOOST_AUTO_TEST_CASE(inverse_functions) {
  Worst of_atan2;
  Worst of_asin;
  Worst of_acos;
  Dice dice(2);
  for (int i = 0; i < cases; ++i) {
    const double x = of_any_size(dice, -300, 300);
    for (const double y : {x * of_any_size(dice, -2, 2), x * of_any_size(dice, -7, 7),
                           of_any_size(dice, -300, 300)}) {
      const Exact right = atan2(Exact(y), Exact(x));
      if (abs(right) > std::numeric_limits<double>::min()) {
        of_atan2.see(elementary::atan2(y, x), right);
      }
    }
    const double ratio =
        i % 2 == 0 ? dice.uniform(-1, 1) : dice.sign() * (1 - dice.power_of_ten(-16, 0));
    of_asin.see(elementary::asin(ratio), asin(Exact(ratio)));
    of_acos.see(elementary::acos(ratio), acos(Exact(ratio)));
  }
  for (int i = 1; i <= 16; ++i) {
    of_atan2.see(elementary::atan2(1.0 * i, 16.0), atan2(Exact(i), Exact(16)));
    of_atan2.see(elementary::atan2(-1.0 * i, 16.0), atan2(Exact(-i), Exact(16)));
    of_atan2.see(elementary::atan2(16.0, -1.0 * i), atan2(Exact(16), Exact(-i)));
  }
  BOOST_TEST(of_atan2.value() <= atan2_error);
  BOOST_TEST(of_asin.value() <= inverse_error);
  BOOST_TEST(of_acos.value() <= inverse_error);
}

BOOST_AUTO_TEST_CASE(exponential_logarithm_hypotenuse) {
  Worst of_exp;
  Worst of_log;
  Worst of_hypot;
  Dice dice(3);
  for (int i = 0; i < cases; ++i) {
    const double x = i % 2 == 0 ? dice.uniform(-1, 1) : dice.uniform(-708, 709);
    of_exp.see(elementary::exp(x), exp(Exact(x)));
    const double y = i % 2 == 0 ? dice.uniform(0.5, 2) : dice.power_of_ten(-307, 307);
    of_log.see(elementary::log(y), log(Exact(y)));
    const double a = of_any_size(dice, -300, 300);
    const double b = a * of_any_size(dice, -2, 2);
    of_hypot.see(elementary::hypot(a, b), sqrt(Exact(a) * a + Exact(b) * b));
  }
  BOOST_TEST(of_exp.value() <= exp_error);
  BOOST_TEST(of_log.value() <= log_error);
  BOOST_TEST(of_hypot.value() <= hypot_error);
}

BOOST_AUTO_TEST_CASE(values_of_equal_ratios) {
  Worst of_between;
  Dice dice(5);
  for (int i = 0; i < cases; ++i) {
    const double range = i % 2 == 0 ? 2 : 307;
    const double low = dice.power_of_ten(-range, range);
    const double high = dice.power_of_ten(-range, range);
    const double of = std::floor(dice.power_of_ten(0, 15)) + 1;
    const double part = std::floor(dice.uniform(0, of));
    const Exact t = Exact(part) / of;
    of_between.see(elementary::between(low, high, part, of),
                   exp((1 - t) * log(Exact(low)) + t * log(Exact(high))));
  }
  BOOST_TEST(of_between.value() <= between_error);
  BOOST_TEST(elementary::between(1, 4, 1, 2) == 2);
  BOOST_TEST(elementary::between(1e-3, 1e1, 3, 4) == 1);
}

BOOST_AUTO_TEST_CASE(ends) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double pi = std::numbers::pi;
  using namespace elementary;  // NOLINT(google-build-using-namespace): all of them, in one place

  BOOST_TEST(sin_cos(0.0).sine == 0);
  BOOST_TEST(std::signbit(sin_cos(-0.0).sine));
  BOOST_TEST(sin_cos(0.0).cosine == 1);
  BOOST_TEST(sin_cos(least).sine == least);
  BOOST_TEST(sin_cos(1e22).sine == -0.8522008497671888);
  BOOST_TEST(std::isnan(sin_cos(infinity).sine));
  BOOST_TEST(std::isnan(sin_cos(std::nan("")).cosine));

  for (const auto& [y, x, angle] : {std::tuple(0.0, 1.0, 0.0),
                                    {0.0, -1.0, pi},
                                    {-0.0, -1.0, -pi},
                                    {1.0, 0.0, pi / 2},
                                    {-1.0, 0.0, -pi / 2},
                                    {1.0, 1.0, pi / 4},
                                    {most, most, pi / 4},
                                    {least, least, pi / 4},
                                    {least, most, 0.0},
                                    {most, least, pi / 2},
                                    {least, -most, pi},
                                    {infinity, -infinity, 3 * pi / 4}}) {
    BOOST_TEST(elementary::atan2(y, x) == angle);
  }
  BOOST_TEST(std::isnan(elementary::atan2(std::nan(""), 1)));
  BOOST_TEST(elementary::asin(1.0) == pi / 2);
  BOOST_TEST(elementary::asin(-1.0) == -pi / 2);
  BOOST_TEST(elementary::acos(-1.0) == pi);
  BOOST_TEST(elementary::acos(1.0) == 0);
  BOOST_TEST(std::isnan(elementary::asin(1.1)));

  BOOST_TEST(elementary::exp(0.0) == 1);
  BOOST_TEST(elementary::exp(-infinity) == 0);
  BOOST_TEST(elementary::exp(710.0) == infinity);
  BOOST_TEST(elementary::exp(-745.0) == least);
  BOOST_TEST(elementary::log(1.0) == 0);
  BOOST_TEST(elementary::log(0.0) == -infinity);
  BOOST_TEST(elementary::log(least) == -1074 * std::numbers::ln2);
  BOOST_TEST(elementary::log(infinity) == infinity);
  BOOST_TEST(std::isnan(elementary::log(-1.0)));
  BOOST_TEST(elementary::pow(10.0, 0.0) == 1);
  BOOST_TEST(elementary::hypot(3 * least, 4 * least) == 5 * least);
  BOOST_TEST(elementary::hypot(most, 0.0) == most);
  BOOST_TEST(elementary::hypot(-infinity, 1.0) == infinity);
}

// The sum stands for the bits themselves: it was made on x86-64 with g++ 12 and is the same with
// clang, with and without a fused multiply-add, and in WebAssembly.
BOOST_AUTO_TEST_CASE(every_machine_computes_the_same_bits) {
  std::uint64_t sum{0};
  const auto add = [&](double value) {
    sum = std::rotl(sum, 7) ^ std::bit_cast<std::uint64_t>(value);
  };
  Dice dice(4);
  for (int i = 0; i < cases; ++i) {
    const double x = dice.uniform(-100, 100);
    const double y = dice.uniform(-1, 1);
    const auto at = elementary::sin_cos(x);
    add(at.sine);
    add(at.cosine);
    add(elementary::atan2(x, y));
    add(elementary::atan2(y, x));
    add(elementary::asin(y));
    add(elementary::acos(y));
    add(elementary::exp(x));
    add(elementary::log(std::abs(x)));
    add(elementary::hypot(x, y));
    add(elementary::between(std::abs(x), std::abs(y), i, cases));
  }
  BOOST_TEST(sum == 6818133537829435326U);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
