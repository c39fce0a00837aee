// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "generated_docs.hpp"
#include "json_schema.hpp"
#include "options/options.hpp"

#include <stillpoint/report/report.hpp>
#include <stillpoint/report/schemas.hpp>

BOOST_AUTO_TEST_SUITE(schema_test)

using namespace stillpoint::cli_test;
namespace cli = stillpoint::cli;

const fs::path data_dir = STILLPOINT_DATA_DIR;
const Arguments plain_design("design --v0 1 --p 1 --beta 0.9 --json");

std::vector<std::string> scene_faults(const json& scene) {
  static const json schema = data_json("schemas/scene.schema.json");
  return schema_faults(schema, scene, UnknownProperties::pass);
}

std::vector<std::string> report_faults(const json& report,
                                       UnknownProperties unknown = UnknownProperties::pass) {
  return schema_faults(report_schema(report["schema"]), report, unknown);
}

BOOST_AUTO_TEST_SUITE(scene_schema)

BOOST_AUTO_TEST_CASE(matches_the_options) {
  BOOST_TEST(text_of(data_dir / "schemas/scene.schema.json") == cli::scene_schema(),
             "the options have changed: build stillpoint_docs and write what `stillpoint_docs "
             "scene-schema` prints into data/schemas/scene.schema.json");
}

BOOST_AUTO_TEST_CASE(allows_every_scene_that_is_shipped) {
  for (const fs::path& path : json_files("scenes")) {
    const std::vector<std::string> faults = scene_faults(data_json(path));
    BOOST_TEST(faults.empty(), path << ": " << (faults.empty() ? "" : faults.front()));
  }
}

/// The schema accepts what the program accepts, and refuses what the program refuses by key or
/// type.
BOOST_FIXTURE_TEST_CASE(agrees_with_the_program, Sandbox) {
  const std::map<std::string, bool> scenes{
      {R"({"v0": 1, "p": 1, "f": 0.02, "delta": 0.02})", true},
      {R"({"period": 2, "velocity": 1, "f": 0.1, "delta-m": 0.01})", true},
      {R"({"period": 2, "velocity": 1, "f": 0.1, "delta_m": 0.01})", true},
      {R"({"p": 1, "f": 0.1, "delta": 0, "excitation": "half-sine", "k": 1, "lambda": 3})", true},
      {R"({"p": 1, "f": 0.1, "delta": 0,
           "excitation": {"type": "harmonic", "k": 1, "lambda": 3, "t_end": 9}})",
       true},
      {R"({"v0": 1, "p": 1, "f": 0.02, "delta": 0.02, "colour": "red"})", false},
      {R"({"v0": 1, "p": 1, "f": true, "delta": 0.02})", false},
      {R"({"v0": 1, "p": 1, "f": null, "delta": 0.02})", false},
      {R"({"v0": 1, "p": 1, "f": 0.02, "delta": 0.02, "title": 3})", false},
      {R"({"v0": 1, "p": 1, "f": 0.02, "delta": 0.02, "max_half_cycles": 2.5})", false},
      {R"({"v0": 1, "p": 1, "f": 0.02, "delta": 0.02, "json": "yes"})", false},
      {R"({"p": 1, "f": 0.1, "delta": 0, "excitation": {}})", false},
      {R"({"p": 1, "f": 0.1, "delta": 0, "excitation": {"type": "harmonic", "beta": 1}})", false},
      {R"([1])", false}};
  for (const auto& [scene, right] : scenes) {
    BOOST_TEST_CONTEXT(scene) {
      BOOST_TEST((run("simulate -", {.input = scene}).exit_code == 0) == right);
      BOOST_TEST(scene_faults(json::parse(scene)).empty() == right);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(report_schemas, Sandbox)

BOOST_AUTO_TEST_CASE(match_the_tables_of_fields) {
  for (const auto& [name, make] : stillpoint::report::report_schemas) {
    BOOST_TEST_CONTEXT(name) {
      const std::string text = text_of(data_dir / "schemas" / (std::string(name) + ".schema.json"));
      BOOST_TEST((text == stillpoint::report::json_text(make())),
                 "write what `stillpoint_docs " << name << "` prints into that file");
    }
  }
}

BOOST_AUTO_TEST_CASE(name_the_same_part_alike) {
  std::map<std::string, json> parts;
  for (const fs::path& path : json_files("schemas")) {
    const json shared = data_json(path).value("$defs", json::object());
    for (const auto& [name, part] : shared.items()) {
      BOOST_TEST(parts.emplace(name, part).first->second == part, path << ": " << name);
    }
  }
}

/// docs/examples are what the commands in docs/reports.md print.
BOOST_AUTO_TEST_CASE(allow_the_reports_that_the_docs_show) {
  const std::string scene = (data_dir / "scenes/isolator.json").string();
  const std::map<std::string, Arguments> commands{
      {"design", {"design", scene, "--json"}},
      {"region", {"region", scene, "--f", "0.024", "--delta-m", "0.006", "--json"}},
      {"simulation", {"simulate", scene, "--f", "0.006", "--delta-m", "0.001", "--json"}}};
  for (const auto& [name, command] : commands) {
    BOOST_TEST_CONTEXT(name) {
      const json shown = data_json("../docs/examples/" + name + ".json");
      const json printed = run(command).json();
      BOOST_TEST(report_faults(shown, UnknownProperties::fail).empty());
      const auto fields = [](const json& report) {
        const json flat = report.flatten();
        std::vector<std::string> places;
        for (const auto& [place, value] : flat.items()) {
          places.push_back(place);
        }
        return places;
      };
      BOOST_TEST(fields(shown) == fields(printed), tt::per_element());
      if (name != "design") {  // which has NLopt's last digits and times of the clock
        BOOST_TEST(shown == printed);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(allow_extra_fields_but_none_missing) {
  json report = run(plain_design).json();
  report["colour"] = "red";
  BOOST_TEST(report_faults(report).empty());
  BOOST_TEST(report_faults(report, UnknownProperties::fail).size() == 1U);
  report.erase("colour");
  report["cases"][0]["motions"][0]["response"].erase("stop_time");
  BOOST_TEST(!report_faults(report).empty());
}

BOOST_AUTO_TEST_CASE(find_each_kind_of_fault) {
  const json report = run(plain_design).json();
  BOOST_TEST_REQUIRE(report_faults(report).empty());
  const std::vector<std::pair<std::string, json>> faults{
      {"/program/name", "other"},
      {"/program/version", "one"},
      {"/input/criterion", "best"},
      {"/input/beta", -1},
      {"/region/feasible", nullptr},
      {"/search/evaluations", 2.5},
      {"/search/status", ""},
      {"/cross_check/methods/0/name", 7},
      {"/cases/0/motions/0/response/stop_time", "soon"},
      {"/constraints", json::object()},
      {"/constraints/4/relation", "is"},
      {"/region/conflict", json::array()}};
  for (const auto& [place, value] : faults) {
    json wrong = report;
    wrong[json::json_pointer(place)] = value;
    BOOST_TEST(!report_faults(wrong).empty(), place);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
