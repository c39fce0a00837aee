// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <stillpoint/answers/exit_code.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/report/report.hpp>

BOOST_AUTO_TEST_SUITE(failed_check_test)

namespace {

using namespace stillpoint;
using namespace stillpoint::cli_test;
using design::Prediction;

design::DesignRequest plain_request() {
  design::DesignRequest request;
  request.problem = {1, 1, 0.8, design::Criterion::published};
  return request;
}

/// The design, but checked against a prediction that `spoil` has changed.
template <class Spoil>
design::DesignResult checked_against(const design::DesignRequest& request, const Spoil& spoil) {
  const design::Problem& problem = request.problem;
  design::DesignResult result = design::design(request);
  const design::DesignPoint point = result.finding.value().point;
  Prediction prediction = design::predict(problem, point.f);
  spoil(prediction);
  result.finding->cross_check = design::cross_check(prediction, problem, point.f, point.delta);
  return result;
}

void check_failure(const design::DesignResult& result) {
  BOOST_TEST(answers::exit_code(report::DesignReport{result}) == 4);
  const nlohmann::ordered_json json = report::json(report::DesignReport{result});
  BOOST_TEST(json["cross_check"]["passed"] == false);
  bool disagrees = false;
  for (const auto& method : json["cross_check"]["methods"]) {
    disagrees = disagrees || method["passed"] == false;
  }
  BOOST_TEST(disagrees);
  const std::string text = report::text(document(report::DesignReport{result}));
  BOOST_TEST(contains(text, "DISAGREES"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(right_prediction_passes) {
  const auto result = checked_against(plain_request(), [](Prediction&) {});
  BOOST_TEST(answers::exit_code(report::DesignReport{result}) == 0);
  BOOST_TEST(report::json(report::DesignReport{result})["cross_check"]["passed"] == true);
}

BOOST_AUTO_TEST_CASE(wrong_prediction_is_exit_code_4_with_a_report) {
  using Spoil = void (*)(Prediction&);
  for (const Spoil spoil :
       {Spoil([](Prediction& prediction) { prediction.peak_amplitude *= 1 + 1e-6; }),
        Spoil([](Prediction& prediction) { prediction.stop_time *= 1 - 1e-6; }),
        Spoil([](Prediction& prediction) { prediction.half_cycles = 2; })}) {
    check_failure(checked_against(plain_request(), spoil));
  }
}

BOOST_AUTO_TEST_CASE(no_design_is_exit_code_3) {
  design::DesignRequest request = plain_request();
  request.problem.beta = 0.6;
  BOOST_TEST(answers::exit_code(report::DesignReport{design::design(request)}) == 3);
}

BOOST_AUTO_TEST_SUITE_END()
