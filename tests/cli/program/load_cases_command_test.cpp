// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(load_cases_command_test)

using namespace stillpoint::cli_test;

/// Lines of seconds and g.
constexpr std::string_view record = "0 0.3\n0.5 -0.2\n1 0.1\n1.5 0\n";

struct Cases : Sandbox {
  Cases() { write("a.txt", std::string(record)); }

  /// A scene with these cases, run in a folder below.
  json scene(const json& cases, json common = json::object()) {
    common.update({{"period", "2.8s"}, {"cases", cases}});
    write("scene.json", common.dump());
    return common;
  }
  void refused(const json& cases, const Texts& words, const json& common = json::object()) {
    scene(cases, common);
    check_refusal(run({"design", "scene.json"}), words);
  }
};

constexpr double hand_tolerance = 1e-12;  // of what units make of a number

const json service{{"name", "service"},
                   {"velocity", "0.1m/s"},
                   {"max_displacement", "60mm"},
                   {"residual_m", "30mm"}};
const json shaken{{"name", "shaken"}, {"record", "a.txt"}, {"max-displacement", "120mm"}};
const json pulse{{"name", "pulse"},          {"pulse", "half-sine"}, {"k", 0.2},
                 {"pulse_duration", "0.3s"}, {"residual_m", "30mm"}, {"arrivals", 3}};

BOOST_FIXTURE_TEST_CASE(each_case_has_its_load_limits_and_motions, Cases) {
  scene({service, shaken, pulse}, {{"title", "three"}});
  const json report = reported({"design", "scene.json"});
  const json& cases = report["cases"];
  BOOST_REQUIRE(cases.size() == 3U);
  BOOST_TEST(cases[0]["name"] == "service");
  BOOST_TEST(cases[0]["load"]["type"] == "hit");
  BOOST_TEST(cases[1]["load"]["type"] == "records");
  BOOST_TEST(cases[1]["load"]["records"] == 1);
  BOOST_TEST(cases[2]["load"]["type"] == "half-sine");
  BOOST_TEST(cases[0]["motions"].size() == 1U);
  BOOST_TEST(near(cases[2]["motions"][0]["k"], 0.2, hand_tolerance));
  // H is that of the hit, so that its v0 is omega.
  const double p = report["design"]["p"].get<double>();
  BOOST_TEST(near(cases[0]["motions"][0]["v0"], p, hand_tolerance));
  for (const json& now : report["constraints"]) {
    BOOST_TEST(now["satisfied"] == true);
    BOOST_TEST(!now["case"].is_null());
    BOOST_TEST(!now["motion"].is_null());
  }
  BOOST_TEST(report["constraints"][0]["case"] == "service");
  BOOST_TEST(report["constraints"][0]["name"] == "amplitude");
  BOOST_TEST(report["cases"][1]["worst"]["peak_m"].get<double>() <= 0.12);
  const json motion =
      reported({"simulate", "--velocity", "0.1", "--period", "2.8", "--f",
                in_full(report["design"]["f"]), "--delta-m", in_full(report["design"]["delta_m"])});
  BOOST_TEST(near(cases[0]["nominal"]["peak_m"], motion["physical"]["peak_m"], 1e-9));
}

BOOST_FIXTURE_TEST_CASE(the_case_that_cannot_be_met_is_named, Cases) {
  json hard = shaken;
  hard["acceleration-max"] = 0.001;
  scene({service, hard});
  const ProgramRun answer = run({"design", "scene.json", "--json"});
  BOOST_TEST(answer.exit_code == 3);
  const json report = json::parse(answer.out);
  bool violated = false;
  for (const json& now : report["constraints"]) {
    violated = violated || (now["satisfied"] == false && now["case"] == "shaken");
  }
  BOOST_TEST(violated);
  for (const json& mend : report["mends"]) {
    BOOST_TEST(mend["case"] == "shaken");
  }
}

BOOST_FIXTURE_TEST_CASE(wrong_cases_are_refused, Cases) {
  const auto with = [](json base, const json& more) {
    base.update(more);
    return base;
  };
  const auto list = [](const std::vector<json>& cases) { return json(cases); };
  refused(json::array(), {"cases", "at least one object"});
  refused(list({{{"velocity", "1m/s"}}}), {"cases", "must have a name"});
  refused({service, service}, {"cases", "service", "is the name of two cases"});
  refused(list({{{"name", "idle"}}}),
          {"case idle", "has no load", "velocity, a pulse or a record"});
  refused(list({with(service, {{"record", "a.txt"}})}), {"case service", "velocity", "record"});
  refused(list({with(service, {{"f-max", 0.1}})}), {"f-max", "cannot stand in a case", "outside"});
  refused(list({with(service, {{"velocty", 1}})}), {"velocty", "did you mean", "velocity"});
  refused(list({with(service, {{"residual_m", "-1mm"}})}),
          {"residual-m in case service", "must be"});
  refused(list({with(pulse, {{"pulse_duration", "0.2s:0.3s"}})}),
          {"pulse-duration in case pulse", "a case for each"});
  refused(list({with(shaken, {{"record", "none.txt"}})}), {"none.txt", "cannot be read"});
  refused(list({with(service, {{"velocity", "0.01mm/s:0.2m/s"}})}),
          {"velocity in case service", "must begin at 0"});
  refused(list({with(service, {{"k", 0.1}})}), {"case service", "k means nothing with velocity"});
  refused(list({with(shaken, {{"arrivals", 2}})}), {"arrivals means nothing with record"});
  refused(list({with(pulse, {{"velocity", "0.1m/s"}})}), {"case pulse", "cannot be combined"});
  refused({service, shaken}, {"objective-case", "must be", "service", "shaken"},
          {{"objective-case", "other"}});
  scene({service, shaken});
  check_refusal(run({"region", "scene.json"}), {"v"});
}

BOOST_AUTO_TEST_SUITE_END()
