// SPDX-License-Identifier: MIT
// Sweeps that are interrupted or killed; commands/sessions/interrupted.txt has what they leave and
// how it is resumed.
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(sweep_resume_test)

using namespace stillpoint::cli_test;

/// A sweep of some tenths of a second.
Arguments sweep(const Arguments& more = {}, const std::string& f = "0.001:0.01:60") {
  return Arguments{"sweep",      "--p",          "1",        "--f", f,     "--delta",
                   "0:0.001:50", "--excitation", "harmonic", "--k", "0.1", "--lambda",
                   "0.9",        "--t-end",      "700"} +
         more;
}

std::uintmax_t size_of(const fs::path& path) {
  std::error_code none;
  const std::uintmax_t size = fs::file_size(path, none);
  return none ? 0 : size;
}

/// Sends the signal as soon as the file has more than this many bytes.
Surroundings signalled(int signal, const fs::path& path, std::uintmax_t above) {
  Surroundings surroundings{.signal = signal};
  surroundings.signal_when = [path, above] { return size_of(path) > above; };
  return surroundings;
}

BOOST_FIXTURE_TEST_CASE(an_interrupt_keeps_the_rows_and_says_how_to_continue, Sandbox) {
  const Arguments rows = sweep("--output rows.csv");
  const json report = run(rows + "--json").json();
  const std::string whole = read("rows.csv");
  fs::remove(path("rows.csv"));
  const ProgramRun stopped = ending(130, rows, signalled(SIGINT, path("rows.csv.part"), 0));
  BOOST_TEST(stopped.out.empty(), stopped.out);
  BOOST_TEST(stopped.err_lines().size() == 1U, stopped.err);
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
  check_contains(stopped.err, {"kept in rows.csv.part", "--resume"});
  BOOST_TEST(contents().size() == 2U);
  const std::string part = read("rows.csv.part");
  BOOST_TEST(part.ends_with('\n'));
  BOOST_TEST((whole.starts_with(part)));

  const json resumed = succeed(rows + "--resume --json --threads 1").json();
  BOOST_TEST(resumed["resumed_at"] > 0);
  BOOST_TEST(resumed["rows"] == 3000);
  BOOST_TEST(resumed["outcomes"] == report["outcomes"]);
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
}

BOOST_FIXTURE_TEST_CASE(a_killed_one_can_be_resumed_from_any_moment, Sandbox) {
  // Half of it must take longer than the tenth of a second before the first checkpoint.
  const std::string f = "0.001:0.01:240";
  for (const std::string name : {"rows.csv", "rows.npy"}) {
    succeed(sweep({"--output", "whole-" + name}, f));
    const std::string whole = read("whole-" + name);
    std::int64_t resumed_at = 0;
    for (std::uintmax_t above : {std::uintmax_t{0}, whole.size() / 3, whole.size() / 2}) {
      const ProgramRun ended = run(sweep({"--output", name, "--resume"}, f),
                                   signalled(SIGKILL, path(name + ".part"), above));
      BOOST_TEST(ended.exit_code == -1);
      BOOST_TEST(!fs::exists(path(name)));
      resumed_at = json::parse(read(name + ".part.json"))["rows"];
    }
    BOOST_TEST(resumed_at > 0);
    const ProgramRun answer = succeed(sweep({"--output", name, "--resume", "--json"}, f));
    BOOST_TEST(answer.json()["resumed_at"] == resumed_at);
    BOOST_TEST(read(name) == whole);
    BOOST_TEST(!fs::exists(path(name + ".part")));
    BOOST_TEST(!fs::exists(path(name + ".part.json")));
  }
}

/// What it has so far is in the checkpoint alone.
BOOST_FIXTURE_TEST_CASE(a_killed_part_without_rows_goes_on_where_it_was, Sandbox) {
  const std::string f = "0.001:0.01:240";
  const Arguments part("--reduce --histogram peak_amplitude:0:1:9 --part 1/1");
  succeed(sweep(part + "--output whole.json", f));
  const auto has_begun = [&] {
    return fs::exists(path("r.json.part.json")) &&
           json::parse(read("r.json.part.json"))["rows"] > 0;
  };
  const ProgramRun ended =
      run(sweep(part + "--output r.json", f), {.signal_when = has_begun, .signal = SIGKILL});
  BOOST_TEST(ended.exit_code == -1);
  BOOST_TEST(!fs::exists(path("r.json")));
  succeed(sweep(part + "--output r.json --resume --threads 1", f));
  BOOST_TEST(read("r.json") == read("whole.json"));
  BOOST_TEST(contents().size() == 2U);
}

BOOST_AUTO_TEST_SUITE_END()
