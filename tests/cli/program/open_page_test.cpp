// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <thread>

BOOST_AUTO_TEST_SUITE(open_page_test)

using namespace stillpoint::cli_test;

const Arguments region("region --v0 1 --p 1 --beta 0.9 --open");

/// A browser that writes its arguments to a file, in one step, once it has seen the page.
void write_browser(const Sandbox& sandbox) {
  sandbox.write("browser.sh",
                "#!/bin/sh\n"
                "for page; do :; done\n"
                "if [ -s \"$page\" ]; then echo \"$@\" > seen.part; mv seen.part seen.txt; fi\n");
  fs::permissions(sandbox.path("browser.sh"), fs::perms::owner_all);
}

Surroundings with_browser(const std::string& command) {
  Surroundings surroundings;
  surroundings.environment.emplace_back("BROWSER", command);
  return surroundings;
}

/// What the browser was started with; the program does not wait for it.
std::string seen(const Sandbox& sandbox) {
  for (int i = 0; i < 3000 && !fs::exists(sandbox.path("seen.txt")); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return sandbox.read("seen.txt");
}

BOOST_FIXTURE_TEST_CASE(shows_the_page_that_is_written, Sandbox) {
  write_browser(*this);
  const std::string program = path("browser.sh").string();
  const ProgramRun answer = succeed(region + "--html page.html", with_browser(program));
  BOOST_TEST(answer.err.empty(), answer.err);
  BOOST_TEST(seen(*this) == path("page.html").string() + "\n");
}

BOOST_FIXTURE_TEST_CASE(shows_a_temporary_page_if_none_is_written, Sandbox) {
  write_browser(*this);
  fs::create_directory(path("tmp"));
  // The first that can be run is taken; %s is the page.
  Surroundings surroundings =
      with_browser("no-such-browser:" + path("browser.sh").string() + " --new-window %s");
  surroundings.environment.emplace_back("TMPDIR", path("tmp").string());
  succeed(region, surroundings);
  const std::string shown = seen(*this);
  BOOST_TEST(shown.starts_with("--new-window " + path("tmp").string() + "/stillpoint-"), shown);
  BOOST_TEST(shown.ends_with("/page.html\n"), shown);
}

// A copy of the program in bin, where it finds the page that is installed beside it, or none.
struct InstalledProgram : Sandbox {
  InstalledProgram() {
    fs::create_directories(path("usr/bin"));
    fs::create_directories(path("usr/share/stillpoint"));
    fs::copy_file(built_program(), path("usr/bin/stillpoint"));
    write_browser(*this);
    surroundings = with_browser(path("browser.sh").string());
    surroundings.program = path("usr/bin/stillpoint").string();
  }
  Surroundings surroundings;
};

BOOST_FIXTURE_TEST_CASE(explores_with_the_installed_page, InstalledProgram) {
  const std::string page = "usr/share/stillpoint/stillpoint.html";
  write(page, "<html></html>");
  BOOST_TEST(run({"explore", "path"}, surroundings).out == path(page).string() + "\n");
  succeed({"explore"}, surroundings);
  BOOST_TEST(seen(*this) == path(page).string() + "\n");
  check_refusal(run({"explore", "elsewhere"}, surroundings),
                {"explore", "elsewhere", "open or path"});
}

BOOST_FIXTURE_TEST_CASE(links_a_design_to_that_page, InstalledProgram) {
  const Arguments design(
      "design --velocity 0.3m/s:0.4m/s --period 2.8s --max-displacement 150mm --html page.html");
  succeed(design, surroundings);
  BOOST_TEST(read("page.html").find("stillpoint.html#") == std::string::npos);
  write("usr/share/stillpoint/stillpoint.html", "<html></html>");
  succeed(design, surroundings);
  const std::string link =
      "href=\"file://" + path("usr/share/stillpoint/stillpoint.html").string() +
      "#max-displacement=150mm&amp;period=2.8s&amp;velocity=0.3m%2Fs:0.4m%2Fs\"";
  BOOST_TEST(read("page.html").find(link) != std::string::npos, read("page.html").substr(0, 4000));
}

BOOST_FIXTURE_TEST_CASE(links_only_what_the_page_can_show, InstalledProgram) {
  write("usr/share/stillpoint/stillpoint.html", "<html></html>");
  write("parts.csv", "name,f,delta\nA,0.3,0.4\n");
  const auto page_of = [&](const std::string& options) {
    succeed(Arguments("design --html page.html") + options.c_str(), surroundings);
    return read("page.html");
  };
  const std::string task = "--v0 1 --p 1 --beta 0.8";
  const std::string shown = "#beta=0.8&amp;p=1.0";
  BOOST_TEST(contains(page_of(task + " --trade-off 3"), shown + "&amp;v0=1.0\""));
  BOOST_TEST(
      contains(page_of(task + " --title 'Roof 3'"), shown + "&amp;title=Roof%203&amp;v0=1.0\""));
  write(
      "scene.json",
      R"({"v0": 1, "p": 1, "beta": 0.8, "excitation": {"type": "harmonic", "k": 0.1, "lambda": 2}})");
  BOOST_TEST(contains(page_of("scene.json"), shown + "&amp;v0=1.0\""));
  BOOST_TEST(contains(page_of("--pulse half-sine --k 6 --lambda 10 --p 1 --beta 1"),
                      "#beta=1.0&amp;k=6.0&amp;lambda=10.0&amp;p=1.0&amp;pulse=half-sine\""));
  write("cases.json", R"({"p": 1, "beta": 2, "cases": [{"name": "A", "v0": 1}]})");
  for (const std::string& beyond : {task + " --catalogue parts.csv", std::string("cases.json")}) {
    BOOST_TEST(page_of(beyond).find("stillpoint.html#") == std::string::npos, beyond);
  }
}

BOOST_FIXTURE_TEST_CASE(says_how_to_build_a_missing_page, InstalledProgram) {
  check_refusal(run({"explore"}, surroundings), {"explore", "not installed", "./dev explorer"});
}

BOOST_FIXTURE_TEST_CASE(is_refused_without_a_browser, Sandbox) {
  Surroundings nothing = with_browser("no-such-browser");
  nothing.environment.emplace_back("PATH", path("").string());
  const auto before = contents();
  check_refusal(run(region + "--html page.html", nothing),
                {"open", "no browser was found", "BROWSER", "--html"});
  BOOST_TEST(contents() == before);
  Surroundings no_room = with_browser("/bin/sh");
  no_room.environment.emplace_back("TMPDIR", path("nowhere").string());
  check_refusal(run(region, no_room), {"open", "temporary page"});
}

BOOST_FIXTURE_TEST_CASE(does_not_happen_after_wrong_input, Sandbox) {
  write_browser(*this);
  check_refusal(run(region + "--f -1", with_browser(path("browser.sh").string())), {"f = -1"});
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  BOOST_TEST(!fs::exists(path("seen.txt")));
}

BOOST_AUTO_TEST_SUITE_END()
