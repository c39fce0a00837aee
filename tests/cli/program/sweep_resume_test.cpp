// SPDX-License-Identifier: MIT
#include "run_program.hpp"
#include "sweep_table.hpp"
#include "testing/printing.hpp"

#include <boost/test/unit_test.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <system_error>

BOOST_AUTO_TEST_SUITE(sweep_resume_test)

namespace {

using namespace stillpoint::cli_test;
using nlohmann::json;
namespace fs = std::filesystem;

/// A sweep of some tenths of a second.
Arguments sweep(const Arguments& more = {}, const std::string& f = "0.001:0.01:60") {
  return joined({"sweep", "--p", "1", "--f", f, "--delta", "0:0.001:50", "--excitation", "harmonic",
                 "--k", "0.1", "--lambda", "0.9", "--t-end", "700"},
                more);
}

std::uintmax_t size_of(const fs::path& path) {
  std::error_code none;
  const std::uintmax_t size = fs::file_size(path, none);
  return none ? 0 : size;
}

/// Sends the signal as soon as the file has more than so many bytes.
Surroundings signalled(int signal, const fs::path& path, std::uintmax_t above) {
  Surroundings surroundings{.signal = signal};
  surroundings.signal_when = [path, above] { return size_of(path) > above; };
  return surroundings;
}

}  // namespace

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
    return run(sweep(joined("--output rows.csv --resume", more)));
  }

  [[nodiscard]] json checkpoint() const { return json::parse(read("rows.csv.part.json")); }

  /// Asserts that resuming is refused and changes nothing.
  void check_refused(const Arguments& more, const std::vector<std::string>& says) const {
    const auto before = contents();
    const ProgramRun answer = resume(more);
    BOOST_TEST(answer.exit_code == 2);
    BOOST_TEST(answer.err_lines().size() == 1U, answer.err);
    check_contains(answer.err, says);
    BOOST_TEST(contents() == before);
  }

  inline static std::string whole;
  inline static json report;  ///< on the whole
  ProgramRun stopped;
};

BOOST_FIXTURE_TEST_SUITE(interrupt, Interrupted)

BOOST_AUTO_TEST_CASE(keeps_the_rows_and_says_how_to_go_on) {
  BOOST_TEST(stopped.out.empty(), stopped.out);
  BOOST_TEST(stopped.err_lines().size() == 1U, stopped.err);
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
  BOOST_TEST(contains(stopped.err, "kept in rows.csv.part"), stopped.err);
  BOOST_TEST(contains(stopped.err, "--resume"), stopped.err);
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
  const ProgramRun answer = run(sweep("--output rows.csv"));
  BOOST_TEST(answer.exit_code == 2);
  check_contains(answer.err, {"rows.csv.part", "--resume", "remove"});
  BOOST_TEST(contents() == before);
}

BOOST_AUTO_TEST_CASE(is_forgotten_with_its_part) {
  fs::remove(path("rows.csv.part"));
  BOOST_TEST(run(sweep("--output rows.csv")).exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
}

BOOST_AUTO_TEST_CASE(refuses_another_task) {
  check_refused("--times", {"rows.csv.part", "columns was", "other options"});
  const ProgramRun other = run("sweep --v0 1 --p 1 --f 0.1 --delta 0 --output rows.csv --resume");
  BOOST_TEST(other.exit_code == 2);
  BOOST_TEST(contains(other.err, "kind was \"forced\", is \"free\""), other.err);
}

BOOST_AUTO_TEST_CASE(refuses_a_part_that_is_too_short) {
  const std::uintmax_t right = checkpoint()["bytes"];
  for (const std::uintmax_t bytes : {right - 1, std::uintmax_t{100}}) {
    fs::resize_file(path("rows.csv.part"), bytes);
    check_refused({}, {std::to_string(bytes) + " bytes", "rows.csv.part.json says", "remove"});
  }
}

BOOST_AUTO_TEST_CASE(cuts_off_what_came_after_its_checkpoint) {
  write("rows.csv.part", read("rows.csv.part") + "0.0010");
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);
}

BOOST_AUTO_TEST_CASE(refuses_a_part_without_its_checkpoint_and_one_that_is_none) {
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

/// Whatever else there is to say of its file: nobody is to remove it.
BOOST_AUTO_TEST_CASE(refuses_while_another_sweep_writes) {
  const int other = ::open(path("rows.csv.part").c_str(), O_RDWR | O_CLOEXEC);
  BOOST_TEST_REQUIRE(::flock(other, LOCK_EX) == 0);
  check_refused({}, {"rows.csv.part: another sweep is writing it"});
  check_refused("--times", {"rows.csv.part: another sweep is writing it"});
  const auto before = contents();
  const ProgramRun anew = run(sweep("--output rows.csv"));
  BOOST_TEST(anew.exit_code == 2);
  BOOST_TEST(contains(anew.err, "rows.csv.part: another sweep is writing it"), anew.err);
  BOOST_TEST(!contains(anew.err, "remove"), anew.err);
  BOOST_TEST(contents() == before);
  ::close(other);
  BOOST_TEST(resume().exit_code == 0);
}

/// Where others may write as well, a link under the name of one of its files leads nowhere.
BOOST_AUTO_TEST_CASE(follows_no_link_from_its_own_files) {
  write("victim", "not ours");
  fs::create_symlink("victim", path("rows.csv.part.json.new"));
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(read("victim") == "not ours");

  fs::create_symlink("victim", path("rows.csv.part"));
  for (const Arguments& more : {Arguments{}, Arguments("--resume")}) {
    BOOST_TEST(run(sweep(joined("--output rows.csv", more))).exit_code == 2);
    BOOST_TEST(read("victim") == "not ours");
  }
}

BOOST_AUTO_TEST_CASE(between_the_last_two_steps_is_tidied_up) {
  json last = checkpoint();
  last["complete"] = true;
  last["rows"] = 3000;
  last["bytes"] = whole.size();
  write("rows.csv.part", whole);
  write("rows.csv.part.json", last.dump());
  BOOST_TEST(resume().exit_code == 0);  // only the name was missing
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
  write("rows.csv.part.json", last.dump());
  BOOST_TEST(resume().exit_code == 0);  // only the checkpoint was left
  BOOST_TEST(read("rows.csv") == whole);
  BOOST_TEST(contents().size() == 1U);
}

/// A checkpoint without its part: nothing is left to go on with, whatever stands under the name of
/// the result, unless that is the result of this very sweep.
BOOST_AUTO_TEST_CASE(without_its_part_begins_anew) {
  json left = checkpoint();
  fs::remove(path("rows.csv.part"));
  write("rows.csv", "of another day");
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);

  left["complete"] = true;
  write("rows.csv.part.json", left.dump());
  fs::remove(path("rows.csv"));
  BOOST_TEST(resume().exit_code == 0);
  BOOST_TEST(read("rows.csv") == whole);

  write("rows.csv.part.json", left.dump());
  BOOST_TEST(resume("--columns f").exit_code == 0);
  BOOST_TEST(read("rows.csv").starts_with("f\n"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(killed, Sandbox)

BOOST_AUTO_TEST_CASE(at_any_moment_leaves_what_can_be_resumed) {
  // Half of it must take longer than the tenth of a second before the first checkpoint.
  const std::string f = "0.001:0.01:240";
  for (const std::string name : {"rows.csv", "rows.npy"}) {
    BOOST_TEST_REQUIRE(run(sweep({"--output", "whole-" + name}, f)).exit_code == 0);
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
    const ProgramRun answer = run(sweep({"--output", name, "--resume", "--json"}, f));
    BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
    BOOST_TEST(answer.json()["resumed_at"] == resumed_at);
    BOOST_TEST(read(name) == whole);
    BOOST_TEST(!fs::exists(path(name + ".part")));
    BOOST_TEST(!fs::exists(path(name + ".part.json")));
  }
}

BOOST_AUTO_TEST_SUITE_END()

namespace {

std::string rows(int count, const std::string& last) {
  std::string text = "f,delta\n";
  for (int i = 1; i < count; ++i) {
    text += std::to_string(i) + "e-5,0.5\n";
  }
  return text + last + "\n";
}

ProgramRun resume(const Sandbox& sandbox, const std::string& list, const Arguments& more = {}) {
  return sandbox.run(joined("sweep --v0 1 --p 1 --list - --output rows.npy --resume", more),
                     {.input = list});
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(list, Sandbox)

BOOST_AUTO_TEST_CASE(with_a_wrong_entry_can_be_mended) {
  constexpr int count = 3000;
  const std::string right = rows(count, "0.1,0.5");
  BOOST_TEST(resume(*this, right).exit_code == 0);
  const std::string whole = read("rows.npy");
  fs::remove(path("rows.npy"));

  const ProgramRun refused = resume(*this, rows(count, "-0.1,0.5"));
  BOOST_TEST(refused.exit_code == 2);
  BOOST_TEST(contains(refused.err, "line 3001: f = -0.1"), refused.err);
  BOOST_TEST(contains(refused.err, "kept in rows.npy.part"), refused.err);
  BOOST_TEST(!fs::exists(path("rows.npy")));

  const auto before = contents();
  std::string other = right;
  other.replace(other.find("1e-5"), 4, "2e-5");
  for (const std::string& wrong : {other, rows(10, "0.1,0.5")}) {
    const ProgramRun changed = resume(*this, wrong);
    BOOST_TEST(changed.exit_code == 2);
    BOOST_TEST(contains(changed.err, "are not those"), changed.err);
    BOOST_TEST(contents() == before);
  }

  const ProgramRun mended = resume(*this, right, "--json");
  BOOST_TEST_REQUIRE(mended.exit_code == 0, mended.err);
  BOOST_TEST(mended.json()["resumed_at"] > 0);
  BOOST_TEST(read("rows.npy") == whole);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(wrong_entry, Sandbox)

/// However many entries are computed at once: all in front of the wrong one are kept, and the rest
/// of the list may be mended.
BOOST_AUTO_TEST_CASE(keeps_every_row_before_it) {
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

BOOST_FIXTURE_TEST_SUITE(resume_option, Sandbox)

BOOST_AUTO_TEST_CASE(begins_where_nothing_is_left) {
  const ProgramRun answer = run(sweep("--output rows.csv --resume --json"));
  BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
  BOOST_TEST(answer.json()["resumed_at"] == 0);
}

BOOST_AUTO_TEST_CASE(goes_on_with_one_that_just_began) {
  write("rows.csv.part", "");
  const ProgramRun answer = run(sweep("--output rows.csv --resume --json"));
  BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
  BOOST_TEST(answer.json()["resumed_at"] == 0);
  BOOST_TEST(answer.json()["rows"] == 3000);
}

BOOST_AUTO_TEST_CASE(needs_a_file) {
  const ProgramRun answer = run(sweep("--resume"));
  BOOST_TEST(answer.exit_code == 2);
  BOOST_TEST(contains(answer.err, "needs an output file"), answer.err);
}

BOOST_AUTO_TEST_CASE(interrupted_standard_output_ends_with_a_whole_row) {
  const ProgramRun stopped =
      run("sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000", {.interrupt = true});
  BOOST_TEST(stopped.exit_code == 130);
  BOOST_TEST((stopped.out.empty() || stopped.out.ends_with('\n')));
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
}

/// Hours of work are announced, once, to whoever reads the log.
BOOST_AUTO_TEST_CASE(long_sweep_says_how_long_it_will_take_where_nobody_watches) {
  const ProgramRun stopped =
      run("sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000 --output /dev/null",
          {.interrupt_once_heard = true});
  BOOST_TEST(stopped.exit_code == 130);
  const auto lines = stopped.err_lines();
  BOOST_TEST_REQUIRE(lines.size() == 2U, stopped.err);
  BOOST_TEST(lines[0].starts_with("stillpoint: "), lines[0]);
  BOOST_TEST(contains(lines[0], " of 1e+12 rows, 0 %, "), lines[0]);
  BOOST_TEST(contains(lines[0], " rows/s: some "), lines[0]);
  BOOST_TEST(lines[0].ends_with(" minutes to go"), lines[0]);
  BOOST_TEST(lines[1].starts_with("stillpoint: interrupted: "), lines[1]);
}

/// A list that comes slowly, and is never finished.
BOOST_AUTO_TEST_CASE(interrupt_is_answered_while_a_list_is_waited_for) {
  fs::path list = path("list");
  BOOST_TEST_REQUIRE(::mkfifo(list.c_str(), 0600) == 0);
  const int writer = ::open(list.c_str(), O_RDWR | O_CLOEXEC);
  const std::string begun = "f,delta\n0.1,0.2\n";
  BOOST_TEST(::write(writer, begun.data(), begun.size()) == static_cast<ssize_t>(begun.size()));
  const ProgramRun stopped = run("sweep --v0 1 --p 1 --list list", {.interrupt = true});
  ::close(writer);
  BOOST_TEST(stopped.exit_code == 130);
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
}

BOOST_AUTO_TEST_CASE(progress_is_shown_on_a_terminal,
                     *boost::unit_test::precondition(if_terminals)) {
  const ProgramRun stopped =
      run("sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000 --output /dev/null",
          {.error_is_terminal = true, .interrupt = true});
  BOOST_TEST(stopped.exit_code == 130);
  check_contains(stopped.err, {" of 1e+12 rows, 0 %, ", " rows/s, ", " left\x1b[K"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
