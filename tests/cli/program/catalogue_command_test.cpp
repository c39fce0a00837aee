// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_AUTO_TEST_SUITE(catalogue_command_test)

using namespace stillpoint::cli_test;
using right::design;

BOOST_FIXTURE_TEST_SUITE(catalogue, Sandbox)

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

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
