// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

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

/// A sandbox with rows of an interrupted sweep into rows.csv, and the text they are to become.
struct Interrupted : Sandbox {
  Interrupted() {
    if (whole.empty()) {
      report = run(sweep("--output rows.csv --json")).json();
      whole = read("rows.csv");
      fs::remove(path("rows.csv"));
    }
    stopped = run(sweep("--output rows.csv"), signalled(SIGINT, path("rows.csv.part"), 0));
    BOOST_TEST_REQUIRE(stopped.exit_code == 130, stopped.err);
  }

  [[nodiscard]] ProgramRun resume(const Arguments& more = {}) const {
    return run(sweep("--output rows.csv --resume" + more));
  }

  [[nodiscard]] json checkpoint() const { return json::parse(read("rows.csv.part.json")); }

  /// Asserts that resuming is refused and changes nothing.
  void check_refused(const Arguments& more, const std::vector<std::string>& says) const {
    const auto before = contents();
    check_refusal(resume(more), says);
    BOOST_TEST(contents() == before);
  }

  inline static std::string whole;
  inline static json report;  ///< on the whole
  ProgramRun stopped;
};

BOOST_FIXTURE_TEST_SUITE(interrupt, Interrupted)

BOOST_AUTO_TEST_CASE(keeps_the_rows_and_says_how_to_continue) {
  BOOST_TEST(stopped.out.empty(), stopped.out);
  BOOST_TEST(stopped.err_lines().size() == 1U, stopped.err);
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
  check_contains(stopped.err, {"kept in rows.csv.part", "--resume"});
  BOOST_TEST(contents().size() == 2U);
  const std::string part = read("rows.csv.part");
  BOOST_TEST(part.ends_with('\n'));
  BOOST_TEST((whole.starts_with(part)));
}

BOOST_AUTO_TEST_CASE(can_be_resumed_into_the_same_bytes) {
  const ProgramRun answer = resume("--json --threads 1");
  BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
  BOOST_TEST(answer.json()["resumed_at"] > 0);
  BOOST_TEST(answer.json()["rows"] == 3000);
  BOOST_TEST(answer.json()["outcomes"] == report["outcomes"]);
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
}

BOOST_AUTO_TEST_CASE(is_not_passed_over) {
  const auto before = contents();
  check_refusal(run(sweep("--output rows.csv")), {"rows.csv.part", "--resume", "remove"});
  BOOST_TEST(contents() == before);
}

BOOST_AUTO_TEST_CASE(is_forgotten_with_its_part) {
  fs::remove(path("rows.csv.part"));
  succeed(sweep("--output rows.csv"));
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
}

BOOST_AUTO_TEST_CASE(refuses_a_part_that_is_too_short) {
  const std::uintmax_t right = checkpoint()["bytes"];
  for (const std::uintmax_t bytes : {right - 1, std::uintmax_t{100}}) {
    fs::resize_file(path("rows.csv.part"), bytes);
    check_refused({}, {std::to_string(bytes) + " bytes", "rows.csv.part.json says", "remove"});
  }
}

BOOST_AUTO_TEST_CASE(drops_what_came_after_its_checkpoint) {
  write("rows.csv.part", read("rows.csv.part") + "0.0010");
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);
}

BOOST_AUTO_TEST_CASE(refuses_a_part_with_no_checkpoint_or_an_invalid_one) {
  const std::string text = read("rows.csv.part.json");
  fs::remove(path("rows.csv.part.json"));
  check_refused({}, {"rows.csv.part.json", "is missing"});
  const std::string deep = R"({"schema": "stillpoint/sweep-checkpoint/1", "task": )" +
                           std::string(200'000, '[') + std::string(200'000, ']') + "}";
  for (const std::string& wrong : {std::string(), std::string("{}"), std::string("[]"),
                                   std::string("{\"schema\": 1}"), std::string("nonsense"), deep}) {
    write("rows.csv.part.json", wrong);
    check_refused({}, {"rows.csv.part.json", "is not the checkpoint of a sweep"});
  }
  write("rows.csv.part.json", text);
  BOOST_TEST(resume().exit_code == 0);
}

/// Whatever else is wrong with its file, the message must not suggest removing it.
BOOST_AUTO_TEST_CASE(refuses_while_another_sweep_writes) {
  const int other = ::open(path("rows.csv.part").c_str(), O_RDWR | O_CLOEXEC);
  BOOST_TEST_REQUIRE(::flock(other, LOCK_EX) == 0);
  check_refused({}, {"rows.csv.part: another sweep is writing it"});
  check_refused("--times", {"rows.csv.part: another sweep is writing it"});
  const auto before = contents();
  const ProgramRun anew = ending(2, sweep("--output rows.csv"));
  BOOST_TEST(contains(anew.err, "rows.csv.part: another sweep is writing it"), anew.err);
  BOOST_TEST(!contains(anew.err, "remove"), anew.err);
  BOOST_TEST(contents() == before);
  ::close(other);
  BOOST_TEST(resume().exit_code == 0);
}

/// In a directory where others may write, a link under the name of one of its files is not
/// followed.
BOOST_AUTO_TEST_CASE(follows_no_link_from_its_own_files) {
  write("victim", "not ours");
  fs::create_symlink("victim", path("rows.csv.part.json.new"));
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(read("victim") == "not ours");

  fs::create_symlink("victim", path("rows.csv.part"));
  for (const Arguments& more : {Arguments{}, Arguments("--resume")}) {
    BOOST_TEST(run(sweep("--output rows.csv" + more)).exit_code == 2);
    BOOST_TEST(read("victim") == "not ours");
  }
}

BOOST_AUTO_TEST_CASE(between_the_last_two_steps_is_tidied_up) {
  json last = checkpoint();
  last["rows"] = 3000;
  last["bytes"] = whole.size();
  write("rows.csv.part", whole);
  write("rows.csv.part.json", last.dump());
  BOOST_TEST(resume().exit_code == 0);  // only the name was missing
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
  write("rows.csv.part.json", last.dump());
  BOOST_TEST(resume().exit_code == 0);  // only the checkpoint was left: begins again
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
}

/// A checkpoint without its part: nothing is left to go on with, whatever stands under the name of
/// the result.
BOOST_AUTO_TEST_CASE(starts_again_without_its_part) {
  const json left = checkpoint();
  fs::remove(path("rows.csv.part"));
  write("rows.csv", "of another day");
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);

  write("rows.csv.part.json", left.dump());
  BOOST_TEST(resume("--columns f").exit_code == 0);
  BOOST_TEST(read("rows.csv").starts_with("f\n"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(killed, Sandbox)

BOOST_AUTO_TEST_CASE(can_be_resumed_from_any_moment) {
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

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(resume_option, Sandbox)

BOOST_AUTO_TEST_CASE(continues_one_that_has_just_begun) {
  write("rows.csv.part", "");
  const ProgramRun answer = succeed(sweep("--output rows.csv --resume --json"));
  BOOST_TEST(answer.json()["resumed_at"] == 0);
  BOOST_TEST(answer.json()["rows"] == 3000);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
