// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(written_files_test, stillpoint::cli_test::Sandbox)

// No command overwrites what it reads, nor writes one file twice.

namespace {

using namespace stillpoint::cli_test;

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
  fs::create_symlink("new.json", sandbox.path("dangling"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(are_never_files_that_are_read) {
  prepare(*this);
  const auto forced = simulate + record;
  const auto before = contents();
  const std::vector<std::pair<Arguments, Texts>> wrong{
      {forced + "--output r.txt", {"output r.txt", "record r.txt"}},
      {forced + "--output ./d/../r.txt", {"output ./d/../r.txt", "record r.txt"}},
      {forced + Arguments{"--output", path("r.txt").string()}, {"output /", "record r.txt"}},
      {forced + "--output link.txt", {"output link.txt", "record r.txt"}},
      {simulate + "--record link.txt --output r.txt", {"output r.txt", "record link.txt"}},
      {forced + "--trajectory r.txt", {"trajectory r.txt", "record r.txt"}},
      {forced + "--html r.txt", {"html r.txt", "record r.txt"}},
      {simulate + "--record d/motion.svg --svg e", {"svg e/motion.svg", "record d/motion.svg"}},
      {"design s.json --output s.json", {"output s.json", "scene s.json"}},
      {"design s.json --html s.json", {"html s.json", "scene s.json"}},
      {"region s.json --output s.json", {"output s.json", "scene s.json"}},
      {"accuracy s.json --f 0.1 --delta 0.1 --output s.json", {"output s.json", "scene s.json"}},
      {list + "--output l.csv", {"output l.csv", "list l.csv"}},
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
      {simulate + "--trajectory m --output d/../m", {"trajectory m", "output d/../m"}},
      {simulate + "--html new.json --output dangling", {"html new.json", "output dangling"}},
      {simulate + "--html e/phase.svg --svg d", {"html e/phase.svg", "svg d/phase.svg"}},
      {simulate + "--output new/phase.svg --svg new",
       {"output new/phase.svg", "svg new/phase.svg"}},
      {design + "--html x --output x", {"html x", "output x"}},
  };
  for (const auto& [arguments, says] : wrong) {
    BOOST_TEST_CONTEXT(says.front()) {
      check_refusal(run(arguments), says);
      BOOST_TEST(contents() == before);
    }
  }
}

// An old report may be replaced, also one of the same name elsewhere; a device takes everything.
BOOST_AUTO_TEST_CASE(are_written_where_nothing_is_lost) {
  prepare(*this);
  for (const Arguments& right : std::vector<Arguments>{
           simulate + "--record r.txt --output d/r.txt",
           simulate + "--record r.txt --output d/r.txt", simulate + "--svg d --output d/map.svg",
           simulate + "--trajectory /dev/null --output /dev/null",
           simulate + "--trajectory /dev/stdout --output /dev/stdout"}) {
    succeed(right);
  }
  BOOST_TEST(read("r.txt") == "0 0\n0.1 0.2\n0.2 0\n");
}

BOOST_AUTO_TEST_SUITE_END()
