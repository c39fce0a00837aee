// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Wrong values are refused, and the message names field, value and bound.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(excitation_test)

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refused(const Excitation& excitation, std::optional<double> t_end = 10, double p = 1) {
  return refused_field([&] {
    (void)forced_response({p, 0.1, 0}, {0, 1}, excitation, {.t_end = t_end});
  });
}

BOOST_AUTO_TEST_CASE(valid_input_is_accepted) {
  BOOST_TEST(refused(Harmonic{0.2, 1, -3, 0}) == "");
  BOOST_TEST(refused(Harmonic{0, 1}) == "");
  BOOST_TEST(refused(Record{{0, 1, 2}, 0, {0, 1, 2}}) == "");
  BOOST_TEST(refused(Record{{0}, 0.1, {}}, std::nullopt) == "");
  BOOST_TEST(refused(HalfSine{-0.5, 20}, std::nullopt) == "");
  BOOST_TEST(refused(Harmonic{1, 1, 0, 0}) == "");
}

BOOST_AUTO_TEST_CASE(waves_out_of_range_are_refused) {
  const std::map<std::string, std::vector<Excitation>> wrong{
      {"k", {Harmonic{not_a_number, 1}, Harmonic{infinity, 1}, FullSine{not_a_number, 1}}},
      {"lambda",
       {Harmonic{1, 0}, Harmonic{1, -1}, Harmonic{1, not_a_number}, HalfSine{1, 0},
        Rectangle{1, infinity}}},
      {"phase", {Harmonic{1, 1, infinity}}},
      {"duration",
       {Harmonic{1, 1, 0, infinity}, Harmonic{1, 1, 0, -1}, Harmonic{1, 1, 0, not_a_number},
        Harmonic{1, 1, 0, 1e-151}}},
      {"record", {Record{}, Record{{1, 1}, 0, {0}}}},
      {"record step", {Record{{1, 1}, 0, {}}}},
      {"record value 2", {Record{{1, not_a_number}, 0.1, {}}}},
      {"record time 1", {Record{{1, 1}, 0, {-1, 0}}}},
      {"record time 2", {Record{{1, 1}, 0, {0, 0}}, Record{{1, 1, 1}, 0, {0, not_a_number, 1}}}}};
  for (const auto& [field, waves] : wrong) {
    for (const Excitation& wave : waves) {
      BOOST_TEST(refused(wave) == field);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_out_of_range_with_respect_to_p_is_refused) {
  BOOST_TEST(refused(Harmonic{1, 1}, 10, 1e13) == "lambda");
  BOOST_TEST(refused(Harmonic{1, 1e-3}, 10, 1.1e9) == "lambda");
  BOOST_TEST(refused(Harmonic{1, 1}, 10, 0.9e-12) == "lambda");
  BOOST_TEST(refused(Harmonic{1e100, 1e-100}, 10, 1e-100) == "k");
  BOOST_TEST(refused(Record{{0, 1e100}, 1, {}}, 10, 1e-100) == "record value 2");
  BOOST_TEST(refused(Record{{0, 1e-9}, 1e-100, {}}, 10, 1e-60) == "record step");
  BOOST_TEST(refused(Record{{0, 1e-9}, 0, {0, 1e-100}}, 10, 1e-60) == "record time 2");
}

BOOST_AUTO_TEST_CASE(the_end_is_needed_and_bounded) {
  for (const std::optional<double> wrong :
       {std::optional<double>(), std::optional(0.0), {-1.0}, {not_a_number}, {1e16}}) {
    BOOST_TEST(refused(Harmonic{1, 1}, wrong) == "t_end");
  }
  BOOST_TEST(refused(NoExcitation{}, 1.1e15) == "t_end");   // p t_end
  BOOST_TEST(refused(Harmonic{1, 1e6}, 1.1e9) == "t_end");  // lambda t_end
  BOOST_TEST(refused(HalfSine{1, 1e6}, 1.1e9).empty());     // lambda only up to its end
  BOOST_TEST(refused(Record{{1, 1}, 1.1e15, {}}, std::nullopt) == "duration");
}

BOOST_AUTO_TEST_CASE(the_duration_is_when_w_becomes_zero) {
  BOOST_TEST(*duration(NoExcitation{}) == 0);
  BOOST_TEST(!duration(Harmonic{1, 1}).has_value());
  BOOST_TEST(*duration(Harmonic{1, 1, 0, 3}) == 3);
  BOOST_TEST(*duration(HalfSine{1, 2}) == std::numbers::pi / 2);
  BOOST_TEST(*duration(FullSine{1, 2}) == std::numbers::pi);
  BOOST_TEST(*duration(Rectangle{1, 4}) == std::numbers::pi / 4);
  BOOST_TEST(*duration(Record{{1, 2, 3}, 0.5, {}}) == 1);
  BOOST_TEST(*duration(Record{{1, 2}, 0, {0.25, 7}}) == 7);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
