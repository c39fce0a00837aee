// SPDX-License-Identifier: MIT
#include "refusal.hpp"
#include "run_program.hpp"
#include "wrong_arguments.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(wrong_scene_test)

namespace {

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;
namespace data = boost::unit_test::data;

}  // namespace

namespace {

Wrong scene(const char* name, const std::string& text, const Texts& says) {
  return {name, {"design", "-"}, says, text};
}

const std::vector<Wrong> scenes{
    scene("empty", "", {"standard input", "empty"}),
    scene("blank", " \n\t\n", {"standard input", "empty"}),
    scene("malformed", "{v0: 1}", {"standard input", "not valid JSON", "line 1"}),
    scene("truncated", "{" + good, {"not valid JSON", "end of input"}),
    scene("truncated_in_a_text", R"({"v0": 1, "title": "half)", {"not valid JSON", "line 1"}),
    scene("more_behind_it", "{" + good + "} {}", {"not valid JSON", "end of input"}),
    scene("comma_behind_the_last_value", "{" + good + ",}", {"not valid JSON"}),
    scene("comment_that_does_not_end", "{" + good + " /* why\n}", {"not valid JSON"}),
    scene("not_utf8", "{\"title\": \"\xff\", " + good + "}", {"not valid JSON"}),
    scene("deeply_nested", std::string(500'000, '['), {"nested deeper"}),
    scene("an_array", "[1, 2]", {"array", "must be an object"}),
    scene("a_number", "17", {"number", "must be an object"}),
    scene("null", "null", {"null", "must be an object"}),
    scene("unknown_key", "{" + good + R"(, "colour": "red"})", {"colour = \"red\"", "not a key"}),
    scene("unknown_key_with_a_neighbour", "{" + good + R"(, "tolerence": 0.1})",
          {"tolerence = 0.1", "mean tolerance?"}),
    scene("key_in_capitals", R"({"V0": 1, "p": 1, "beta": 0.9})", {"V0 = 1", "not a key"}),
    scene("unknown_key_with_a_line_break", "{" + good + R"(, "a\nb": 1})", {"not a key"}),
    scene("repeated_key", "{" + good + R"(, "v0": 1})", {"v0", "twice"}),
    scene("repeated_key_in_two_spellings", "{" + good + R"(, "f_max": 1, "f-max": 1})",
          {"f", "max", "twice"}),
    scene("text_for_a_number", R"({"v0": "1", "p": 1, "beta": 1})", {"v0 = \"1\"", "a number"}),
    scene("null_for_a_number", R"({"v0": null, "p": 1, "beta": 1})", {"v0 = null", "a number"}),
    scene("truth_for_a_number", R"({"v0": true, "p": 1, "beta": 1})", {"v0 = true", "a number"}),
    scene("array_for_a_number", R"({"v0": [1], "p": 1, "beta": 1})", {"v0 = [1]", "a number"}),
    scene("number_for_a_text", "{" + good + R"(, "objective": 1})", {"objective = 1", "a text"}),
    scene("text_for_a_flag", "{" + good + R"(, "json": "yes"})",
          {"json = \"yes\"", "true or false"}),
    scene("fraction_for_a_whole_number", "{" + good + R"(, "samples": 2.5})",
          {"samples = 2.5", "a whole number"}),
    scene("nan", R"({"v0": NaN, "p": 1, "beta": 1})", {"v0", "not valid JSON"}),
    scene("infinity", R"({"v0": 1, "p": 1, "beta": Infinity})", {"beta", "not valid JSON"}),
    scene("place_of_a_fault", "{\n  \"v0\": 1,\n  \"p\" 1\n}",
          {"scene from standard input, line 3, column 7: is not valid JSON after the key p"}),
    scene("end_too_soon", "{\n  \"v0\": 1,\n", {"line 3, column 1: is not valid JSON"}),
    scene("number_beyond_a_double", R"({"v0": 1, "p": 1, "beta": 1e400})",
          {"line 1, column 27: beta = 1e400: must have a magnitude up to 1.8e308"}),
    scene("negative_value", R"({"v0": 1, "p": 1, "beta": -1})", {"beta = -1", "from 1e-300"}),
    scene("contradiction", "{" + good + R"(, "velocity": 1})", {"v0 and velocity", "exclude"}),
    scene("value_missing", R"({"v0": 1, "p": 1})", {"beta is missing"}),
    {"whole_number_beyond_an_integer",
     {"simulate", "-"},
     {"samples = 18446744073709551615", "whole number"},
     R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0.1, "trajectory": "t.csv",
         "samples": 18446744073709551615})"},
    {"contradiction_with_a_flag",
     {"design", "-", "--velocity", "1"},
     {"p and velocity", "exclude each other"},
     "{" + good + "}"},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, scene_text, data::make(scenes), wrong) {
  check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
