// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(sweep_list_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using right::with_input;

Arguments sweep(const Arguments& more = {}) {
  return "sweep --v0 1 --p 1 --list -" + more;
}

const std::string plain = "f,delta\n0.1,0.2\n0.02,0.03\n0,0\n";

BOOST_AUTO_TEST_CASE(of_scenes_gives_each_its_own_start) {
  write("scenes.csv", "v0,p,f,delta\n1,2,0.1,0.1\n2,1,0.1,0.1\n");
  const SweepTable rows =
      check_rows(*this, "simulate", {}, "--list scenes.csv",
                 [](const SweepTable& table, std::size_t row, const json& report) {
                   BOOST_TEST(table.number(row, "peak_amplitude") ==
                              report["response"]["peak_amplitude"].get<double>());
                 });
  BOOST_TEST((rows.columns.front() == "v0" && rows.rows.size() == 2));
}

/// The entries around one that would take too long are computed, and its row says why it was not.
BOOST_AUTO_TEST_CASE(entry_that_takes_too_long_has_a_row_of_its_own) {
  const std::string text = "f,delta,x0\n0.1,0.2,0\n1e-12,1e-30,0\n0.02,0.03,0.5\n";
  const Arguments plainly("sweep --v0 1 --p 1 --list - --times");
  const Arguments forced = plainly + "--excitation half-sine --k 1e-9 --lambda 3";
  for (const Arguments& arguments : {plainly, forced}) {
    const ProgramRun answer = succeed(arguments, with_input(text));
    const SweepTable table = read_csv(answer.out);
    BOOST_TEST_REQUIRE(table.rows.size() == 3U);
    BOOST_TEST(table.at(1, "outcome") == "too_many_half_cycles");
    for (const std::string& column : table.columns) {
      const bool given = column == "f" || column == "delta" || column == "x0";
      BOOST_TEST((given || column == "outcome" || table.at(1, column).empty()), column);
    }
    for (const std::size_t row : {std::size_t{0}, std::size_t{2}}) {
      BOOST_TEST(table.at(row, "outcome") == "stopped_at_zero");
      BOOST_TEST(table.number(row, "peak_amplitude") > 0);
    }
  }
  Surroundings list = with_input(text);
  const auto report = run(plainly + "--output rows.npy --json", list).json();
  BOOST_TEST(report["outcomes"]["too_many_half_cycles"] == 1);
  const NpyFile file = read_npy(read("rows.npy"));
  BOOST_TEST(file.byte(1, "outcome") == 5);
  BOOST_TEST(std::isnan(file.number(1, "half_cycles")));
  BOOST_TEST(std::isnan(file.number(1, "stop_time")));
}

BOOST_AUTO_TEST_CASE(without_entries_gives_no_rows) {
  BOOST_TEST(run(sweep(), with_input("f,delta\n")).out ==
             "f,delta,peak_amplitude,half_cycles,outcome,stop_position\n");
}

// ---- wrong lists

/// Whose first entry is right.
struct WrongList {
  std::string text;
  std::vector<std::string> says;
};

const std::vector<WrongList> wrong_lists{
    {"f,delta\n0.1,0.2\n0.1\n", {"line 3", "has 1 value,", "2 columns"}},
    {"f,delta\n0.1,0.2\n\nabc,1\n", {"line 4", "f = \"abc\"", "must be a number"}},
    {"f,delta\n0.1,0.2\n0.1,-3\n", {"line 3", "delta = -3", "from 0"}},
};

/// The row in front of the wrong one is there, below its header, and nothing else is.
BOOST_AUTO_TEST_CASE(wrong_list_keeps_what_came_before) {
  for (const auto& [text, says] : wrong_lists) {
    const ProgramRun printed = ending(2, sweep(), with_input(text));
    BOOST_TEST(printed.err_lines().size() == 1U, printed.err);
    check_contains(printed.err, says);
    BOOST_TEST(std::ranges::count(printed.out, '\n') == 2);
    const ProgramRun written = ending(2, sweep("--output rows.npy"), with_input(text));
    check_contains(written.err, says);
    BOOST_TEST(written.out.empty());
    BOOST_TEST(contents().size() == 2U);
    BOOST_TEST(json::parse(read("rows.npy.part.json"))["rows"] == 1);
    fs::remove(path("rows.npy.part"));
    fs::remove(path("rows.npy.part.json"));
  }
}

// ---- resumed after a wrong entry

std::string rows(int count, const std::string& last) {
  std::string text = "f,delta\n";
  for (int i = 1; i < count; ++i) {
    text += std::to_string(i) + "e-5,0.5\n";
  }
  return text + last + "\n";
}

ProgramRun resume(const Sandbox& sandbox, const std::string& list, const Arguments& more = {}) {
  return sandbox.run("sweep --v0 1 --p 1 --list - --output rows.npy --resume" + more,
                     {.input = list});
}

/// However many entries are computed at once, all before the wrong one are kept, and the rest
/// of the list may be corrected.
BOOST_AUTO_TEST_CASE(resumed_keeps_every_row_before_the_wrong_entry) {
  const std::string whole_list = rows(200, "0.1,0.5");
  BOOST_TEST(resume(*this, whole_list).exit_code == 0);
  const std::string whole = read("rows.npy");
  for (const std::string& wrong : {std::string("-0.1,0.5"), std::string("a,0.5")}) {
    for (const int at : {2, 150}) {
      fs::remove(path("rows.npy"));
      const ProgramRun refused = resume(*this, rows(at, wrong) + "0.2,0.5\n");
      BOOST_TEST(refused.exit_code == 2);
      BOOST_TEST(contains(refused.err, "line " + std::to_string(at + 1) + ": f = "), refused.err);
      // The same command would only meet the same line again.
      const std::string kept =
          std::string(at == 2 ? "1 row is" : "149 rows are") +
          " kept in rows.npy.part: correct the list, then give the same command with --resume";
      BOOST_TEST(contains(refused.err, kept), refused.err);
      BOOST_TEST(json::parse(read("rows.npy.part.json"))["rows"] == at - 1);
      const ProgramRun mended = resume(*this, whole_list, "--json");
      BOOST_TEST_REQUIRE(mended.exit_code == 0, mended.err);
      BOOST_TEST(mended.json()["resumed_at"] == at - 1);
      BOOST_TEST(read("rows.npy") == whole);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
