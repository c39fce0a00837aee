// SPDX-License-Identifier: MIT
#include "refusal.hpp"
#include "run_program.hpp"
#include "testing/printing.hpp"

#include <boost/test/unit_test.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

BOOST_AUTO_TEST_SUITE(written_files_test)

// No command overwrites what it reads, nor writes one file twice.

namespace {

using namespace stillpoint::cli_test;
namespace fs = std::filesystem;

const std::string scene = R"({"v0": 1, "p": 1, "beta": 0.9})";
const Arguments simulate("simulate --v0 1 --p 1 --f 0.1 --delta 0.1");
const Arguments record("--record r.txt");
const Arguments design("design --v0 1 --p 1 --beta 0.9");
const Arguments list("sweep --v0 1 --p 1 --list l.csv");

/// The files that must survive.
void prepare(const Sandbox& sandbox) {
  sandbox.write("s.json", scene);
  sandbox.write("r.txt", "0 0\n0.1 0.2\n0.2 0\n");
  sandbox.write("l.csv", "f,delta\n0.1,0.2\n");
  fs::create_symlink("r.txt", sandbox.path("link.txt"));
  fs::create_directory(sandbox.path("d"));
  fs::create_directory_symlink("d", sandbox.path("e"));
  sandbox.write("d/motion.svg", "0 0\n0.1 0.2\n0.2 0\n");
  sandbox.write("l.csv.part.json", scene);
  fs::create_symlink("new.json", sandbox.path("dangling"));
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(written_files, Sandbox)

BOOST_AUTO_TEST_CASE(are_never_files_that_are_read) {
  prepare(*this);
  const auto forced = joined(simulate, record);
  const auto before = contents();
  const std::vector<std::pair<Arguments, Texts>> wrong{
      {joined(forced, "--output r.txt"), {"output r.txt", "record r.txt"}},
      {joined(forced, "--output ./d/../r.txt"), {"output ./d/../r.txt", "record r.txt"}},
      {joined(forced, {"--output", path("r.txt").string()}), {"output /", "record r.txt"}},
      {joined(forced, "--output link.txt"), {"output link.txt", "record r.txt"}},
      {joined(simulate, "--record link.txt --output r.txt"), {"output r.txt", "record link.txt"}},
      {joined(forced, "--trajectory r.txt"), {"trajectory r.txt", "record r.txt"}},
      {joined(forced, "--html r.txt"), {"html r.txt", "record r.txt"}},
      {joined(simulate, "--record d/motion.svg --svg e"),
       {"svg e/motion.svg", "record d/motion.svg"}},
      {"design s.json --output s.json", {"output s.json", "scene s.json"}},
      {"design s.json --html s.json", {"html s.json", "scene s.json"}},
      {"region s.json --output s.json", {"output s.json", "scene s.json"}},
      {"accuracy s.json --f 0.1 --delta 0.1 --output s.json", {"output s.json", "scene s.json"}},
      {joined(list, "--output l.csv"), {"output l.csv", "list l.csv"}},
      {"sweep l.csv.part.json --output l.csv", {"output l.csv.part.json", "scene l.csv.part.json"}},
  };
  for (const auto& [arguments, says] : wrong) {
    BOOST_TEST_CONTEXT(says.front()) {
      check_refusal(run(arguments), says);
      BOOST_TEST(contents() == before);
    }
  }
}

BOOST_AUTO_TEST_CASE(of_a_scene_count_too) {
  const std::string text = R"({"v0": 1, "p": 1, "beta": 0.9, "output": "s.json"})";
  write("s.json", text);
  check_refusal(run("design s.json"), {"output s.json", "scene s.json"});
  BOOST_TEST(read("s.json") == text);
  succeed("design s.json --output other.json");
}

BOOST_AUTO_TEST_CASE(are_all_different) {
  prepare(*this);
  const auto before = contents();
  const std::vector<std::pair<Arguments, Texts>> wrong{
      {joined(simulate, "--trajectory m --output d/../m"), {"trajectory m", "output d/../m"}},
      {joined(simulate, "--html new.json --output dangling"), {"html new.json", "output dangling"}},
      {joined(simulate, "--html e/phase.svg --svg d"), {"html e/phase.svg", "svg d/phase.svg"}},
      {joined(simulate, "--output new/phase.svg --svg new"),
       {"output new/phase.svg", "svg new/phase.svg"}},
      {joined(design, "--html x --output x"), {"html x", "output x"}},
  };
  for (const auto& [arguments, says] : wrong) {
    BOOST_TEST_CONTEXT(says.front()) {
      check_refusal(run(arguments), says);
      BOOST_TEST(contents() == before);
    }
  }
}

// A sweep that is running holds a lock on its part; FILE.part.json says how far that is.
BOOST_AUTO_TEST_CASE(are_not_those_of_a_running_sweep) {
  write("m.npy.part", "rows");
  write("m.npy.part.json", "{}");
  fs::create_symlink("m.npy.part", path("other"));
  const int part = ::open(path("m.npy.part").c_str(), O_RDWR);
  BOOST_TEST_REQUIRE(::flock(part, LOCK_EX) == 0);
  const auto before = contents();
  for (const char* const file : {"m.npy.part", "m.npy.part.json", "other"}) {
    check_refusal(run(joined(simulate, {"--output", file})),
                  {"output " + std::string(file) + ": a sweep is writing it"});
    check_refusal(run(joined(simulate, {"--trajectory", file})), {"a sweep is writing it"});
    BOOST_TEST(contents() == before);
  }
  ::close(part);
  succeed(joined(simulate, "--output m.npy.part"));
}

// An old report may be replaced, also one of the same name elsewhere; a device takes everything.
BOOST_AUTO_TEST_CASE(are_written_where_nothing_is_lost) {
  prepare(*this);
  for (const Arguments& right :
       std::vector<Arguments>{joined(simulate, "--record r.txt --output d/r.txt"),
                              joined(simulate, "--record r.txt --output d/r.txt"),
                              joined(simulate, "--svg d --output d/map.svg"),
                              joined(simulate, "--trajectory /dev/null --output /dev/null"),
                              joined(simulate, "--trajectory /dev/stdout --output /dev/stdout")}) {
    succeed(right);
  }
  BOOST_TEST(read("r.txt") == "0 0\n0.1 0.2\n0.2 0\n");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
