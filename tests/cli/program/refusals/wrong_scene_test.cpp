// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_AUTO_TEST_SUITE(wrong_scene_test)

namespace {

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;

Wrong scene(const std::string& text, const Texts& says) {
  return {"design -", says, text};
}

const std::vector<Wrong> scenes{
    scene("", {"standard input", "empty"}),
    scene(" \n\t\n", {"standard input", "empty"}),
    scene("{v0: 1}", {"standard input", "not valid JSON", "line 1"}),
    scene("{" + good, {"not valid JSON", "end of input"}),
    scene(R"({"v0": 1, "title": "half)", {"not valid JSON", "line 1"}),
    scene("{" + good + "} {}", {"not valid JSON", "end of input"}),
    scene("{" + good + ",}", {"not valid JSON"}),
    scene("{" + good + " /* why\n}", {"not valid JSON"}),
    scene("{\"title\": \"\xff\", " + good + "}", {"not valid JSON"}),
    scene("[1, 2]", {"array", "must be an object"}),
    scene("{" + good + R"(, "colour": "red"})", {"colour = \"red\"", "not a key"}),
    scene("{" + good + R"(, "tolerence": 0.1})", {"tolerence = 0.1", "mean tolerance?"}),
    scene(R"({"V0": 1, "p": 1, "beta": 0.9})", {"V0 = 1", "not a key"}),
    scene("{" + good + R"(, "a\nb": 1})", {"not a key"}),
    scene("{" + good + R"(, "v0": 1})", {"line 1, column 32: v0 is set twice"}),
    {"simulate -",
     {"line 2, column 2: friction-zones 1: f = -0.1"},
     "{\"v0\": 1, \"p\": 1, \"f\": 0.1, \"delta\": 0.1,\n \"friction_zones\": [{\"to\": 0.1, "
     "\"f\": -0.1}]}"},
    {"simulate -",
     {"friction-zones = []: must have at least one zone"},
     R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0.1, "friction_zones": []})"},
    scene("{" + good + R"(, "arrivals": 1e9})", {"arrivals = 1000000000", "from 1 to 1000"}),
    scene("{" + good + R"(, "arrivals": 2.5})",
          {"arrivals = 2.5: must be a whole number from 1 to 1000"}),
    scene("{" + good + R"(, "f_max": 1, "f-max": 1})", {"f", "max", "twice"}),
    scene(R"({"v0": "1", "p": 1, "beta": 1})", {"v0 = \"1\"", "a number"}),
    scene(R"({"v0": true, "p": 1, "beta": 1})", {"v0 = true", "a number"}),
    scene(R"({"v0": {"low": 1}, "p": 1, "beta": 1})", {"a number, or a range [LOW, HIGH]"}),
    scene(R"({"v0": [1], "p": 1, "beta": 1})", {"v0 = [1]", "a number"}),
    scene("{" + good + R"(, "objective": 1})", {"objective = 1", "a string"}),
    scene("{" + good + R"(, "json": "yes"})", {"json = \"yes\"", "true or false"}),
    scene("{" + good + R"(, "samples": 2.5})", {"samples = 2.5", "a whole number"}),
    scene(R"({"v0": 1, "p": 1, "beta": Infinity})", {"beta", "not valid JSON"}),
    scene("{\n  \"v0\": 1,\n  \"p\" 1\n}",
          {"scene from standard input, line 3, column 7: is not valid JSON after the key p"}),
    scene("{\n  \"v0\": 1,\n", {"line 3, column 1: is not valid JSON"}),
    scene(R"({"v0": 1, "p": 1, "beta": 1e400})",
          {"line 1, column 27: beta = 1e400: must have a magnitude up to 1.8e308"}),
    // The place of a value in its file: of a wrong type, out of range, within the excitation, one
    // end of a range, and one that makes another value wrong.
    scene("{\n  // the stroke\n  \"v0\": 1, \"p\": 1,\n  \"beta\": \"x\"\n}",
          {"scene from standard input, line 4, column 3: beta = \"x\": must be a number"}),
    scene("{\n\"title\": \"a\\n\\\"b\\\"\",\n " + good + ",\n  \"residual\": -1}",
          {"scene from standard input, line 4, column 3: residual = -1: must be"}),
    scene("{\n" + good + ",\n \"colour\": 1}", {"line 3, column 2: colour = 1: is not a key"}),
    scene("{\"p\": [1, 2],\n\"v0\": [2, 1], \"beta\": 1}", {"line 2, column 1: v0 = 2:1: must be"}),
    scene("{\"velocity\": 1, \"period\": 1,\n \"max_displacement\": 0}",
          {"line 2, column 2: max-displacement = 0 m: must be"}),
    {"simulate -",
     {"line 2, column 31: lambda = -1: must be"},
     R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0.1, "t_end": 9, "excitation":
  {"type":"harmonic", "k": 1, "lambda": -1}})"},
    {"simulate -",
     {"velocity = [0.3,0.4]: must be one number, not a range"},
     R"({"velocity": [0.3, 0.4], "period": 1, "f": 0.1, "delta_m": 0})"},
    {"simulate -",
     {R"(record = ["a","b"]: must be one path)"},
     R"({"record": ["a", "b"], "period": 1, "f": 0.1, "delta_m": 0})"},
    {"region -",
     {"velocity is missing: only design, simulate, spectrum, sweep and accuracy take records"},
     R"({"record": ["a", "b"], "period": 1})"},
    {"simulate -",
     {"line 1, column 2: excitation = {}: must be a string, or an object with a \"type\""},
     R"({"excitation": {}, "p": 1})"},
    {"design -",
     {"title = \"a?b\": must not contain a NUL"},
     "{" + good + R"(, "title": "a\u0000b"})"},
    // A flag has no place.
    {"design - --beta -1", {"stillpoint: beta = -1: must be"}, "{" + good + "}"},
    {"simulate -",
     {"samples = 18446744073709551615", "whole number"},
     R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0.1, "trajectory": "t.csv",
         "samples": 18446744073709551615})"},
    {"design - --velocity 1", {"p and velocity", "cannot be combined"}, "{" + good + "}"},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, scene_text, data::make(scenes), wrong) {
  check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
