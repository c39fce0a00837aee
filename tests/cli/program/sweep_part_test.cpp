// SPDX-License-Identifier: MIT
// Sweeps in parts, and the parts joined again.
#include "refusal.hpp"
#include "run_program.hpp"

#include <fmt/format.h>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <csignal>
#include <filesystem>
#include <string>

BOOST_AUTO_TEST_SUITE(sweep_part_test)

namespace {

using namespace stillpoint::cli_test;
namespace fs = std::filesystem;

const Arguments grid{"sweep", "--v0", "1", "--p", "1", "--f", "0.02:0.35:13", "--delta", "0:0.5:5"};

}  // namespace

struct Parts : Sandbox {
  /// Writes part i of n to I-of-N.EXTENSION.
  [[nodiscard]] ProgramRun part(const Arguments& sweep, int i, int n,
                                const std::string& extension = "csv",
                                const Arguments& more = {}) const {
    return run(
        joined(sweep, joined({"--part", std::to_string(i) + "/" + std::to_string(n), "--output",
                              "{part}." + extension, "--threads", std::to_string(1 + i % 3)},
                             more)));
  }

  /// Writes all parts; their names.
  [[nodiscard]] Arguments split(const Arguments& sweep, int n,
                                const std::string& extension = "csv") const {
    Arguments names;
    const std::string count = std::to_string(n);
    for (int i = n; i >= 1; --i) {
      const ProgramRun answer = part(sweep, i, n, extension);
      BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
      names.push_back(fmt::format("{:0{}}-of-{}.{}", i, count.size(), count, extension));
    }
    return names;
  }

  [[nodiscard]] ProgramRun merge(const Arguments& parts) const {
    return run(joined({"sweep", "merge", "merged"}, parts));
  }

  void check_merged(const Arguments& sweep, int n, const std::string& extension) const {
    BOOST_TEST_CONTEXT(n << " parts, " << extension) {
      const ProgramRun whole = run(joined(sweep, {"--output", "whole." + extension}));
      BOOST_TEST_REQUIRE(whole.exit_code == 0, whole.err);
      const ProgramRun answer = merge(split(sweep, n, extension));
      BOOST_TEST(answer.exit_code == 0, answer.err);
      BOOST_TEST((read("merged") == read("whole." + extension)));
    }
  }

  /// Asserts that they cannot be joined, why, and that nothing is written.
  void check_refused(const Arguments& parts, const Texts& says) const {
    const auto before = contents();
    check_refusal(merge(parts), says);
    BOOST_TEST(contents() == before);
  }
};

BOOST_FIXTURE_TEST_SUITE(parts, Parts)

BOOST_AUTO_TEST_CASE(of_a_grid_merge_to_the_bytes_of_the_whole) {
  for (const char* extension : {"csv", "npy"}) {
    for (const int n : {1, 4, 12}) {
      check_merged(grid, n, extension);
    }
  }
}

BOOST_AUTO_TEST_CASE(may_be_more_than_there_are_entries) {
  const Arguments three{"sweep", "--v0", "1", "--p", "1", "--f", "0,0.1,0.2", "--delta", "0.3"};
  check_merged(three, 5, "csv");
  check_merged(three, 5, "npy");
}

BOOST_AUTO_TEST_CASE(of_lists_designs_and_forced_motions_do_too) {
  write("list.csv", "f,delta\n0.1,0.2\n\n0.3,0.1\n0.02,0.03\n0.05,0\n0.2,0.25\n");
  const Arguments v0_and_p{"sweep", "--v0", "1", "--p", "1"};
  check_merged(joined(v0_and_p, {"--list", "list.csv"}), 3, "csv");
  check_merged(joined(v0_and_p, {"--list", "list.csv"}), 3, "npy");
  check_merged(joined(v0_and_p, {"--beta", "0.6:0.9:7"}), 2, "npy");
  check_merged({"sweep", "--p", "1", "--f", "0.05:0.2:5", "--delta", "0", "--excitation",
                "harmonic", "--k", "0.2", "--lambda", "0.35", "--t-end", "20"},
               2, "csv");
}

BOOST_AUTO_TEST_CASE(may_go_to_standard_output) {
  write("whole", run(grid).out);
  for (const char* part : {"1/2", "2/2"}) {
    write(std::string("part") + part[0], run(joined(grid, {"--part", part})).out);
  }
  BOOST_TEST(merge({"part1", "part2"}).exit_code == 0);
  BOOST_TEST((read("merged") == read("whole")));
}

BOOST_AUTO_TEST_CASE(may_be_given_by_a_launcher) {
  write("whole", run(grid).out);
  Arguments names;
  for (const char* rank : {"0", "1", "2"}) {
    Surroundings ranked;
    ranked.environment = {{"OMPI_COMM_WORLD_RANK", rank}, {"OMPI_COMM_WORLD_SIZE", "3"}};
    const ProgramRun answer =
        run(joined(grid, {"--part", "auto", "--output", "{part}.csv", "--json"}), ranked);
    BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
    names.push_back(answer.json().at("output").at("file"));
  }
  BOOST_TEST(names.front() == "1-of-3.csv");
  BOOST_TEST(merge(names).exit_code == 0);
  BOOST_TEST((read("merged") == read("whole")));
}

BOOST_AUTO_TEST_CASE(report_their_number) {
  const auto report = part(grid, 2, 3, "csv", {"--json"}).json();
  BOOST_TEST(report.at("part").at("number") == 2);
  BOOST_TEST(report.at("part").at("count") == 3);
  BOOST_TEST(report.at("rows") == 22);  // of 65 the first two parts have 22
  BOOST_TEST(run(joined(grid, {"--output", "whole.csv", "--json"})).json().at("part").is_null());
}

BOOST_AUTO_TEST_CASE(that_are_complete_are_not_computed_again) {
  static_cast<void>(split(grid, 2));
  const auto written = fs::last_write_time(path("1-of-2.csv"));
  const auto again = part(grid, 1, 2, "csv", {"--resume", "--json"}).json();
  BOOST_TEST(again.at("resumed_at") == again.at("rows"));
  BOOST_TEST((fs::last_write_time(path("1-of-2.csv")) == written));
  BOOST_TEST(part(grid, 1, 2).exit_code == 0);  // without --resume as any file
  BOOST_TEST((fs::last_write_time(path("1-of-2.csv")) > written));
}

BOOST_AUTO_TEST_CASE(are_not_written_over_each_other) {
  for (const Arguments& more : {Arguments{}, Arguments{"--resume"}}) {
    const Arguments one_file = joined(grid, {"--output", "one.csv"});
    static_cast<void>(run(joined(one_file, {"--part", "1/2"})));
    const auto before = contents();
    const ProgramRun answer = run(joined(one_file, joined({"--part", "2/2"}, more)));
    check_refusal(answer, {"one.csv", "1/2", "{part}"});
    BOOST_TEST(contents() == before);
  }
}

BOOST_AUTO_TEST_CASE(that_were_killed_are_resumed) {
  const Arguments forced{"sweep",         "--p",     "1",          "--f",
                         "0.001:0.01:60", "--delta", "0:0.001:50", "--excitation",
                         "harmonic",      "--k",     "0.1",        "--lambda",
                         "0.9",           "--t-end", "700"};
  const Arguments second = joined(forced, {"--part", "2/3", "--output", "2-of-3.csv"});
  Surroundings killed;
  killed.signal = SIGKILL;
  killed.signal_when = [this] {
    std::error_code none;
    const auto size = fs::file_size(path("2-of-3.csv.part"), none);
    return !none && size > 0;
  };
  BOOST_TEST_REQUIRE(run(second, killed).exit_code == -1);
  BOOST_TEST(!fs::exists(path("2-of-3.csv")));
  const ProgramRun resumed = run(joined(second, {"--resume", "--json"}));
  BOOST_TEST_REQUIRE(resumed.exit_code == 0, resumed.err);
  for (const int i : {1, 3}) {
    static_cast<void>(part(forced, i, 3));
  }
  static_cast<void>(run(joined(forced, {"--output", "whole.csv"})));
  BOOST_TEST(merge({"1-of-3.csv", "2-of-3.csv", "3-of-3.csv"}).exit_code == 0);
  BOOST_TEST((read("merged") == read("whole.csv")));
}

BOOST_AUTO_TEST_CASE(that_are_missing_or_doubled_are_refused) {
  const Arguments names = split(grid, 3);  // the third comes first
  check_refused({names[0], names[2]}, {"2/3", "is missing"});
  check_refused({names[2]}, {"2/3", "is missing", "2"});
  check_refused(joined(names, {names[1]}), {names[1], "is part 2/3", "like"});
  fs::copy_file(path(names[1]), path("copy.csv"));
  check_refused(joined(names, {"copy.csv"}), {"copy.csv", "is part 2/3", "like " + names[1]});
  check_refused({}, {"PART"});
  check_refused(joined(names, {"none.csv"}), {"none.csv", "No such file"});
}

/// Wherever it is cut and whichever byte is changed.
BOOST_AUTO_TEST_CASE(that_are_torn_are_refused) {
  for (const char* extension : {"csv", "npy"}) {
    const Arguments names = split(grid, 2, extension);
    const std::string& torn = names[0];
    const std::string whole = read(torn);
    const std::size_t step = whole.size() / 23;
    for (std::size_t size = 0; size < whole.size(); size += step) {
      write(torn, whole.substr(0, size));
      check_refused(names, {torn, "no whole part"});
    }
    write(torn, whole.substr(0, whole.size() - 1));
    check_refused(names, {torn, "no whole part"});
    write(torn, whole + "\n");
    check_refused(names, {torn, "no whole part"});
    const std::size_t seal = whole.find("#stillpoint-part");
    for (std::size_t place = 0; place < seal; place += step) {
      std::string changed = whole;
      changed[place] = static_cast<char>(changed[place] ^ 1);
      write(torn, changed);
      check_refused(names, {torn, "has changed"});
    }
  }
}

BOOST_AUTO_TEST_CASE(of_other_sweeps_are_refused) {
  const Arguments names = split(grid, 2);
  const auto check_foreign = [&](const Arguments& sweep, const Texts& says) {
    static_cast<void>(run(joined(sweep, {"--part", "2/2", "--output", "foreign"})));
    check_refused({names[1], "foreign"}, joined({"foreign", names[1]}, says));
    fs::remove(path("foreign"));
  };
  Arguments other = grid;
  other[6] = "0.02:0.36:13";
  check_foreign(other, {"f was", "0.02:0.36:13"});
  check_foreign(joined(grid, {"--times"}), {"columns"});
  check_foreign(joined(grid, {"--format", "npy"}), {"format"});
  static_cast<void>(run(joined(grid, {"--part", "3/3", "--output", "foreign"})));
  check_refused({names[1], "foreign"}, {"foreign", "3/3", names[1], "1/2"});
  static_cast<void>(run(joined(grid, {"--output", "foreign"})));  // not in parts
  check_refused({names[1], "foreign"}, {"foreign", "no whole part"});
}

BOOST_AUTO_TEST_CASE(of_a_list_that_has_changed_are_refused) {
  const Arguments sweep{"sweep", "--v0", "1", "--p", "1", "--list", "list.csv"};
  write("list.csv", "f,delta\n0.1,0.2\n0.3,0.1\n");
  static_cast<void>(part(sweep, 1, 2));
  write("list.csv", "f,delta\n0.2,0.2\n0.3,0.1\n");
  static_cast<void>(part(sweep, 2, 2));
  check_refused({"1-of-2.csv", "2-of-2.csv"}, {"2-of-2.csv", "list"});
}

BOOST_AUTO_TEST_CASE(are_not_overwritten_by_the_whole) {
  const Arguments names = split(grid, 2);
  fs::create_symlink(names[0], path("merged"));
  check_refused(names, {"merged", "overwrite"});
}

BOOST_AUTO_TEST_SUITE_END()

namespace {

const Wrong wrong_parts[] = {
    {"none of none", joined(grid, {"--part", "0/3"}), {"part", "0/3", "1 <= I <= N"}},
    {"beyond the last", joined(grid, {"--part", "4/3"}), {"part", "4/3", "1 <= I <= N"}},
    {"without a count", joined(grid, {"--part", "3"}), {"part", "\"3\"", "I/N"}},
    {"with more", joined(grid, {"--part", "1/2/3"}), {"part", "1/2/3", "I/N"}},
    {"too many", joined(grid, {"--part", "1/1000001"}), {"part", "1/1000001", "1000000"}},
    {"of no launcher", joined(grid, {"--part", "auto"}), {"part = auto", "no launcher", "I/N"}},
    {"of a count that is none", joined(grid, {"--part", "auto/0"}), {"part", "auto/N"}},
    {"with a page", joined(grid, {"--part", "1/2", "--html", "a.html"}), {"part", "page"}},
    {"of standard input",
     {"sweep", "--v0", "1", "--p", "1", "--part", "1/2", "--list", "-"},
     {"part", "standard input"},
     "f,delta\n0.1,0.2\n"},
    {"merge with options", joined(grid, {"merge", "a", "b"}), {"merge", "no options"}}};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, wrong_parts_are_refused, boost::unit_test::data::make(wrong_parts),
                       wrong) {
  check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
