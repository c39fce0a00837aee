// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(design_test)

using namespace stillpoint::design_test;

BOOST_AUTO_TEST_CASE(a_design_in_one_line) {
  // Where amplitude does not bind, the best tolerance by the published criterion is 0.36336.
  DesignRequest request{.problem = {1, 1, 0.9, Criterion::published}};
  DesignResult result = design::design(request);
  const std::string line = summary(result);
  BOOST_TEST(line.starts_with("f = 0."), line);
  BOOST_TEST(line.find(" within 36.3 %: stops at x = 0 at tau = ") != std::string::npos, line);
  BOOST_TEST(line.find(" after 1 half-cycle, peak 0.") != std::string::npos, line);
  BOOST_TEST(!line.ends_with("the cross-check failed"), line);
  result.finding->cross_check.passed = false;
  BOOST_TEST(summary(result) == line + "; the cross-check failed");
  request.problem.beta = 0.5;
  result = design::design(request);
  BOOST_TEST(summary(result) == "no damper: " + result.reason.value());
  const RegionAnswer region = answer(RegionRequest{{1, 1, 0.9}});
  BOOST_TEST(summary(region).starts_with("admissible for f from 0."), summary(region));
  BOOST_TEST(summary(region).ends_with(" to 0.353553"), summary(region));  // f3 = V0 p / sqrt(8)
}

template <class Enum>
void names_lead_back(std::size_t count) {
  BOOST_TEST(names<Enum>().size() == count);
  for (const std::string_view text : names<Enum>()) {
    BOOST_TEST(name(parse<Enum>(text).value()) == text);
  }
  for (const char* const wrong : {"", "Exact", "none"}) {
    BOOST_TEST(!parse<Enum>(wrong).has_value());
  }
}

BOOST_AUTO_TEST_CASE(each_name_leads_back_to_its_enumerator) {
  names_lead_back<Criterion>(2);
  names_lead_back<PulseWarning>(2);
  names_lead_back<Objective>(4);
  names_lead_back<HitEnd>(8);
  BOOST_TEST(names<Objective>().front() == name(Objective::robust));
}

BOOST_AUTO_TEST_CASE(wrong_numbers_of_arrivals_are_refused) {
  for (const std::int64_t wrong :
       {std::int64_t{0}, std::int64_t{-1}, most_arrivals + 1, std::int64_t{1'000'000'000}}) {
    BOOST_CHECK_THROW(
        static_cast<void>(design::design(DesignRequest{{1, 1, 0.9, Criterion::exact, wrong}})),
        InputError);
  }
  DesignRequest pulsed{{1, 1, 0.9, Criterion::exact, 2}};
  pulsed.pulse = HalfSine{2, 20};
  BOOST_CHECK_THROW(static_cast<void>(design::design(pulsed)), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
