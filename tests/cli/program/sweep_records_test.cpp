// SPDX-License-Identifier: MIT
// Sweeps over several records and their scales.
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(sweep_records_test)

using namespace stillpoint::cli_test;

/// Times in tau and values in g, which a factor of a power of 2 scales without rounding.
struct Records : Sandbox {
  Records() {
    write("a.txt", "0 0\n1 0.5\n2 -0.25\n3 0\n");
    write("b, c.txt", "0 0\n1 -0.25\n2 0.75\n3 0\n");
  }
};
const Arguments motions("sweep --p 1 --f 0.03,0.1 --delta 0.02");
const Arguments both = motions + Arguments{"--record", "a.txt", "--record", "b, c.txt"};

/// The lines of a sweep without their header and these first cells.
std::vector<std::string> rows_of(const std::string& csv, const std::string& first = "") {
  std::vector<std::string> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    if (line.starts_with(first)) {
      rows.push_back(line.substr(first.size()));
    }
  }
  return rows;
}

BOOST_FIXTURE_TEST_SUITE(records, Records)

// Each record and scale has the rows of a sweep of its own, bit for bit: the scales are powers
// of 2.
BOOST_AUTO_TEST_CASE(make_the_rows_of_sweeps_of_their_own) {
  const std::string all = succeed(both + "--record-scale 0.5,2").out;
  BOOST_TEST(all.starts_with("record,record_scale,f,"));
  BOOST_TEST(rows_of(all).size() == 8);
  for (const char* scale : {"0.5", "2"}) {
    for (const auto& [name, cell] :
         {std::pair{"a.txt", "a.txt,"}, std::pair{"b, c.txt", "\"b, c.txt\","}}) {
      const std::string alone =
          succeed(motions + Arguments{"--record", name, "--record-scale", scale}).out;
      BOOST_TEST(alone.starts_with("f,"));
      BOOST_TEST((rows_of(all, std::string(cell) + scale + ",") == rows_of(alone)));
    }
  }
}

BOOST_AUTO_TEST_CASE(of_a_single_scale_have_no_column_of_it) {
  const std::string all = succeed(both + "--record-scale 2").out;
  BOOST_TEST(all.starts_with("record,f,"));
  BOOST_TEST((rows_of(all, "a.txt,") ==
              rows_of(succeed(motions + "--record a.txt --record-scale 2").out)));
  const std::string scaled = succeed(motions + "--record a.txt --record-scale 1,2").out;
  BOOST_TEST(scaled.starts_with("record_scale,f,"));
}

// 0.5 g to 1 g, and 0.75 g to 1 g.
BOOST_AUTO_TEST_CASE(are_scaled_to_a_peak_first) {
  BOOST_TEST((rows_of(succeed(both + "--record-peak 1").out, "a.txt,") ==
              rows_of(succeed(motions + "--record a.txt --record-scale 2").out)));
}

BOOST_AUTO_TEST_CASE(may_be_of_a_folder_or_a_list) {
  write("list.csv", "file,scale\na.txt,2\n\"b, c.txt\",1\n");
  const std::string listed = succeed(motions + "--records-list list.csv").out;
  BOOST_TEST((rows_of(listed, "a.txt,") ==
              rows_of(succeed(motions + "--record a.txt --record-scale 2").out)));
  fs::create_directory(path("folder"));
  write("folder/1.txt", read("a.txt"));
  write("folder/2.txt", read("b, c.txt"));
  const std::string found = succeed(motions + "--record folder").out;
  BOOST_TEST((rows_of(found, "folder/1.txt,") == rows_of(succeed(motions + "--record a.txt").out)));
  BOOST_TEST(rows_of(found).size() == 4);
}

BOOST_AUTO_TEST_CASE(are_named_in_the_report) {
  const auto report = run(both + "--output rows.npy --json").json();
  BOOST_TEST((report.at("record") == nlohmann::json({"a.txt", "b, c.txt"})));
  const auto reduced = run(both + "--reduce --best peak_amplitude:1:largest --json").json();
  const auto& best = reduced.at("best").at(0).at("rows").at(0);
  BOOST_TEST(best.at("record") == 1);
}

BOOST_AUTO_TEST_CASE(may_be_in_seconds) {
  const Arguments seconds("sweep --period 2.8 --f 0.03 --delta-m 1mm");
  const std::string all = succeed(seconds + "--record a.txt --record-scale 1,2 --times").out;
  BOOST_TEST((rows_of(all, "2,") ==
              rows_of(succeed(seconds + "--record a.txt --record-scale 2 --times").out)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
