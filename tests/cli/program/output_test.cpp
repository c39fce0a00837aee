// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <sys/stat.h>

BOOST_AUTO_TEST_SUITE(output_test)

using namespace stillpoint::cli_test;
using right::design;

bool is_report(const std::string& text) {
  const json report = json::parse(text, nullptr, false);
  return report.is_object() && report.value("schema", "") == "stillpoint/design-report/2";
}

bool has_escapes(const std::string& text) {
  return text.find('\x1b') != std::string::npos;
}

/// The mask of new files, for as long as this lives; the program inherits it.
class Mask {
 public:
  explicit Mask(mode_t mask) : before_(::umask(mask)) {}
  Mask(const Mask&) = delete;
  Mask& operator=(const Mask&) = delete;
  ~Mask() { ::umask(before_); }

 private:
  mode_t before_;
};

unsigned permissions(const fs::path& path) {
  return static_cast<unsigned>(fs::status(path).permissions());
}

Surroundings on_terminal() {
  return {.output = StandardOutput::terminal};
}

Surroundings into_file(const fs::path& path) {
  return {.output = StandardOutput::file, .output_file = path.string()};
}

/// A title, a key and a name with CSI (U+009B), a mark from right to left (U+202E), an isolate
/// (U+2066) and a blank without width (U+200B).
BOOST_FIXTURE_TEST_CASE(no_control_or_mark_of_direction_reaches_a_terminal, Sandbox) {
  const std::string marks =
      "a\xC2\x9B"
      "31m\xE2\x80\xAE\xE2\x81\xA6\xE2\x80\x8B"
      "b\xC3\xBC";
  write(marks + ".txt", "0 0\n1 0.5\n2 0\n");
  const auto runs = [&](const Arguments& arguments, const std::string& input = "") {
    ProgramRun answer = run(arguments, {.input = input});
    for (const char* const mark : {"\xC2\x9B", "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x80\x8B"}) {
      BOOST_TEST(!contains(answer.out + answer.err, mark), answer.out << answer.err);
    }
    BOOST_TEST(contains(answer.out + answer.err, "b\xC3\xBC"), answer.out << answer.err);
    return answer;
  };
  const Arguments title{"--title", marks};
  check_contains(runs(design() + title).out, {R"(: a\x9b31m\u202e\u2066\u200bb)"});
  BOOST_TEST(runs("design -", R"({")" + marks + R"(": 1})").exit_code == 2);
  BOOST_TEST(runs(Arguments{"design", "--" + marks}).exit_code == 2);
  BOOST_TEST(runs(Arguments{"design", marks}).exit_code == 2);
  const Arguments motion("simulate --p 1 --f 0.01 --delta 0");
  BOOST_TEST(runs(motion + Arguments{"--record", marks + ".txt"}).exit_code == 0);
  const ProgramRun report = runs(motion + Arguments{"--json", "--record", marks + ".txt"});
  check_contains(report.out, {R"(a\u009b31m\u202e\u2066\u200bb)"});
  BOOST_TEST(report.json()["input"]["excitation"]["record"] == marks + ".txt");
  BOOST_TEST(runs(motion + Arguments{"--record", marks + ".no"}).exit_code == 2);
  BOOST_TEST(runs(design("--catalogue -"), "name,f,delta\n" + marks + ",0.2,0.3\n").exit_code == 2);
}

BOOST_FIXTURE_TEST_SUITE(file, Sandbox)

BOOST_AUTO_TEST_CASE(replaces_an_old_file) {
  write("report.json", std::string(100'000, '#'));
  fs::create_hard_link(path("report.json"), path("old"));
  succeed(design("--output report.json"));
  BOOST_TEST(is_report(read("report.json")));
  // Never written into: a reader of the old file still sees all of it.
  BOOST_TEST(read("old") == std::string(100'000, '#'));
  BOOST_TEST(contents().size() == 2U);
}

BOOST_AUTO_TEST_CASE(may_be_in_another_directory) {
  fs::create_directory(path("reports"));
  succeed(design("--output reports/new.json"));
  succeed(design({"--output", path("reports/absolute.json").string()}));
  BOOST_TEST(is_report(read("reports/new.json")));
  BOOST_TEST(is_report(read("reports/absolute.json")));
  BOOST_TEST(contents().size() == 3U);
}

BOOST_AUTO_TEST_CASE(keeps_a_link_and_replaces_what_it_points_to) {
  fs::create_directory(path("elsewhere"));
  write("elsewhere/target.json", "old");
  fs::create_symlink("elsewhere/target.json", path("link.json"));
  succeed(design("--output link.json"));
  BOOST_TEST(fs::is_symlink(path("link.json")));
  BOOST_TEST(!fs::is_symlink(path("elsewhere/target.json")));
  BOOST_TEST(is_report(read("elsewhere/target.json")));
  BOOST_TEST(contents().size() == 3U);
}

BOOST_AUTO_TEST_CASE(keeps_a_link_to_a_missing_file) {
  fs::create_symlink("later.json", path("link.json"));
  succeed(design("--output link.json"));
  BOOST_TEST(fs::is_symlink(path("link.json")));
  BOOST_TEST(is_report(read("link.json")));
}

BOOST_AUTO_TEST_CASE(is_refused_if_links_form_a_loop) {
  fs::create_symlink("b.json", path("a.json"));
  fs::create_symlink("a.json", path("b.json"));
  const auto before = contents();
  check_refusal(run(design("--output a.json")), {"output a.json: cannot be written"});
  BOOST_TEST(contents() == before);
}

BOOST_AUTO_TEST_CASE(has_the_permissions_of_any_new_file) {
  for (const unsigned mask : {0022U, 0077U, 0002U}) {
    const Mask set(mask);
    const std::string name = "report" + std::to_string(mask) + ".json";
    succeed(design({"--output", name}));
    BOOST_TEST(permissions(path(name)) == (0666U & ~mask));
  }
}

BOOST_AUTO_TEST_CASE(may_be_the_standard_output) {
  const ProgramRun text = succeed(design("--output /dev/stdout"));
  const std::size_t behind = text.out.find("\n}\n");
  BOOST_TEST_REQUIRE(behind != std::string::npos);
  BOOST_TEST(is_report(text.out.substr(0, behind + 3)));
  BOOST_TEST(text.out.substr(behind + 3).starts_with("Damper design\n"));
  succeed(design("--output /dev/null"));
  BOOST_TEST(contents().empty());
}

BOOST_AUTO_TEST_CASE(that_is_standard_output_is_appended_to) {
  write("log", "a line from before\n");
  succeed(design("--output /dev/stdout"), into_file(path("log")));
  const std::string log = read("log");
  BOOST_TEST(log.starts_with("a line from before\n"));
  check_contains(log, {"design-report/2", "Damper design\n"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(colour, Sandbox, *boost::unit_test::precondition(if_terminals))

const std::vector<Arguments> reports{design(), "design --v0 1 --p 1 --beta 0.6",
                                     "region --v0 1 --p 1 --beta 0.8 --f 0.3 --delta 0.01",
                                     "simulate --v0 1 --p 1 --f 0.02 --delta 0.02"};

BOOST_AUTO_TEST_CASE(only_on_a_terminal) {
  for (const Arguments& arguments : reports) {
    BOOST_TEST(!has_escapes(run(arguments).out));
    BOOST_TEST(has_escapes(run(arguments, on_terminal()).out));
    static_cast<void>(run(arguments, into_file(path("report.txt"))));
    BOOST_TEST(!has_escapes(read("report.txt")));
  }
}

BOOST_AUTO_TEST_CASE(as_the_environment_says) {
  const auto coloured = [&](const Arguments& arguments, const char* name, const char* value) {
    const std::string text =
        run(arguments, {.environment = {{name, value}}, .output = StandardOutput::terminal}).out;
    BOOST_TEST(!text.empty());
    return has_escapes(text);
  };
  for (const Arguments& arguments : reports) {
    BOOST_TEST(!coloured(arguments, "NO_COLOR", "1"));
  }
  BOOST_TEST(coloured(design(), "NO_COLOR", ""));
  BOOST_TEST(!coloured(design(), "TERM", "dumb"));
}

BOOST_AUTO_TEST_CASE(not_in_json) {
  const ProgramRun answer = run(design("--json"), on_terminal());
  BOOST_TEST(!has_escapes(answer.out));
  BOOST_TEST(is_report(answer.out));
}

BOOST_AUTO_TEST_CASE(not_in_the_file_beside_a_coloured_report) {
  BOOST_TEST(has_escapes(run(design("--output report.json"), on_terminal()).out));
  BOOST_TEST(!has_escapes(read("report.json")));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
