// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_AUTO_TEST_SUITE(catalogue_command_test)

namespace {

using namespace stillpoint::cli_test;
using right::design;

/// f2 = 0.10556, f3 = 0.35355, Delta2 = 0.5; f = 0.26 and delta = 0.37 are near the best.
const std::string few =
    "name,f,delta\nweak,0.05,0.4\ngood,0.26,0.37\nfair,0.2,0.4\nstrong,0.4,0.4\n";

Arguments isolator(const Arguments& more = {}) {
  return "design --velocity 0.4 --period 2.8 --max-displacement 0.15" + more;
}

std::vector<std::string> names(const json& catalogue) {
  std::vector<std::string> list;
  for (const json& part : catalogue) {
    list.push_back(part["name"]);
  }
  return list;
}

}  // namespace

/// With those parts in few.csv.
struct Few : Sandbox {
  Few() { write("few.csv", few); }
};

BOOST_FIXTURE_TEST_SUITE(catalogue, Few)

BOOST_AUTO_TEST_CASE(of_100_MB_is_refused_before_it_is_read_to_its_end) {
  {
    std::ofstream file(path("huge.csv"));
    file << "name,f,delta\n";
    for (int i = 0; i <= 100'000; ++i) {
      file << 'p' << i << ",0.2,0.4\n";
    }
  }
  fs::resize_file(path("huge.csv"), 100'000'000);
  check_refusal(run(design("--catalogue huge.csv")),
                {"catalogue huge.csv", "line 100002", "more than 100000 parts"});
  write("one_line.csv", "name,f,delta\n");
  fs::resize_file(path("one_line.csv"), 100'000'000);
  check_refusal(run(design("--catalogue one_line.csv")),
                {"catalogue one_line.csv", "line 2", "65536 bytes"});
}

BOOST_AUTO_TEST_CASE(may_be_written_in_many_ways) {
  const json expected = reported(design("--catalogue few.csv"));
  const std::vector<std::string> spellings{
      "name,f,delta\r\nweak,0.05,0.4\r\ngood,0.26,0.37\r\nfair,0.2,0.4\r\nstrong,0.4,0.4",
      "\xEF\xBB\xBF" + few,
      "\ndelta, price ,f,name\n0.4,12,0.05,weak\n\n0.37,15,2.6e-1,good\n.4,,0.2, fair\n"
      "0.4,9,0.4,\"strong\"\n"};
  for (const std::string& text : spellings) {
    const json report = reported(design("--catalogue -"), {.input = text});
    BOOST_TEST(report["catalogue"] == expected["catalogue"], text);
    BOOST_TEST(report["design"] == expected["design"]);
  }
}

BOOST_AUTO_TEST_CASE(names_may_have_quotes_and_commas) {
  const json report = reported(design("--catalogue -"),
                               {.input = "name,note,f,delta\n\"Slider 8\"\" disc, "
                                         "long\",\"two\nlines, \"\"x\"\"\",0.26,\"0.37\"\n"});
  BOOST_TEST(report["design"]["name"] == R"(Slider 8" disc, long)");
  check_refusal(run(design("--catalogue -"), {.input = "name,f,delta\n\"a\" b,0.1,0.2\n"}),
                {"line 2", "text follows a closing quote"});
  check_refusal(run(design("--catalogue -"), {.input = "name,f,delta\n\"a\nb\",0.1,0.2\n"}),
                {"line 3", "name = a?b", "printable"});
}

BOOST_AUTO_TEST_CASE(is_ranked_and_explained) {
  const json report = reported(design("--catalogue few.csv"));
  const std::vector<std::string> order{"good", "fair", "strong", "weak"};
  BOOST_TEST(names(report["catalogue"]) == order, tt::per_element());
  check_values(report["design"], {{"name", "good"}, {"f", 0.26}, {"delta", 0.37}});
  BOOST_TEST(report["search"].is_null());
  BOOST_TEST(report["cross_check"]["passed"] == true);
  BOOST_TEST(report["input"]["catalogue"] == "few.csv");
  // The same point by `region`.
  const json point = reported("region --v0 1 --p 1 --beta 0.9 --f 0.26 --delta 0.37");
  BOOST_TEST(report["design"]["tolerance"] == point["design"]["tolerance"]);
  BOOST_TEST(report["constraints"] == point["constraints"]);
  BOOST_TEST(report["works_for"] == point["works_for"]);
  const json& good = report["catalogue"][0];
  BOOST_TEST(good["admissible"] == true);
  BOOST_TEST(good["why"].is_null());
  BOOST_TEST(good["violates"].empty());
  BOOST_TEST(report["catalogue"][3]["tolerance"].is_null());
}

BOOST_AUTO_TEST_CASE(without_a_part_that_fits_ends_with_3_and_says_why_for_each) {
  const ProgramRun answer = ending(3, design("--catalogue few.csv --tolerance 0.5 --json"));
  const json report = answer.json();
  BOOST_TEST(report["design"].is_null());
  BOOST_TEST(!report["region"]["reason"].is_null());
  for (const json& part : report["catalogue"]) {
    BOOST_TEST(part["admissible"] == false);
    BOOST_TEST(part["why"].is_string());
  }
  // The mend is the tolerance of the best part.
  BOOST_TEST_REQUIRE(report["mends"].size() == 1U);
  BOOST_TEST(report["mends"][0]["input"] == "tolerance");
  BOOST_TEST(near(report["mends"][0]["value"], report["catalogue"][0]["tolerance"], 1e-14));
}

BOOST_AUTO_TEST_CASE(in_metres_may_carry_units) {
  write("metres.csv", "name,f,delta_m\na,0.02,6mm\nb,0.02,0.006\nc,0.02,0.6cm\n");
  const json report = reported(isolator("--catalogue metres.csv"));
  for (const json& part : report["catalogue"]) {
    BOOST_TEST(near(part["delta_m"], 0.006, 1e-15));
    BOOST_TEST(part["delta"] == report["catalogue"][0]["delta"]);
    BOOST_TEST(part["admissible"] == true);
  }
  write("wrong.csv", "name,f,delta_m\na,0.02,6mm\nb,0.02,6s\n");
  check_refusal(run(isolator("--catalogue wrong.csv")),
                {"catalogue wrong.csv, line 3", "delta-m = \"6s\"", "mm"});
  write("negative.csv", "name,f,delta_m\na,0.02,-6mm\n");
  check_refusal(run(isolator("--catalogue negative.csv")),
                {"catalogue negative.csv, line 2", "delta_m = -6mm", "from 0"});
}

BOOST_AUTO_TEST_CASE(is_drawn_by_region_and_works_with_arrivals) {
  write("few.csv", "name,f,delta\nfirst,0.26,0.37\nsecond,0.05,0.2\nfar,9,9\n");
  const Arguments region("region --v0 1 --p 1 --beta 1.1 --catalogue few.csv --svg out --arrivals");
  BOOST_TEST(reported(region + "2")["catalogue"][1]["admissible"] == true);
  const std::string figure = read("out/region.svg");
  BOOST_TEST(contains(figure, "parts that fit"));
  BOOST_TEST(!contains(figure, "tolerate too little"));
  // The first withstands 35 %.
  BOOST_TEST(run(region + "1 --tolerance 0.4").exit_code == 3);
  const std::string strict = read("out/region.svg");
  BOOST_TEST(
      contains(strict, "data-name=\"parts that tolerate too little\" data-at=\"0.26 0.37\""));
  BOOST_TEST(!contains(strict, "parts that fit"));
}

/// Its only part is too weak for the first return, and stops the mass at the second.
BOOST_AUTO_TEST_CASE(that_needs_more_arrivals_says_how_many) {
  write("weak.csv", "name,f,delta\nsecond,0.05,0.2\n");
  const json report =
      ending(3, "design --v0 1 --p 1 --beta 1.1 --catalogue weak.csv --json").json();
  check_values(report["mends"][0], {{"input", "arrivals"}, {"value", 2}});
}

BOOST_AUTO_TEST_CASE(is_not_overwritten_and_may_be_in_a_scene) {
  check_refusal(run(design("--catalogue few.csv --output few.csv")),
                {"few.csv", "would overwrite the catalogue few.csv"});
  BOOST_TEST(read("few.csv") == few);
  write("scene.json", R"({"v0": 1, "p": 1, "beta": 0.9, "catalogue": "few.csv", "trade_off": 3})");
  const json report = reported("design scene.json");
  BOOST_TEST(report["design"]["name"] == "good");
  BOOST_TEST(report["trade_off"].size() == 3U);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
