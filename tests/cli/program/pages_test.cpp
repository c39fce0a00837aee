// SPDX-License-Identifier: MIT
// What README.md and docs/ say is true: each command in them runs, each output that they show is
// printed, each link leads somewhere.
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(pages_test)

using namespace stillpoint::cli_test;

const fs::path root = fs::path(STILLPOINT_DATA_DIR).parent_path();

std::vector<fs::path> pages() {
  std::vector<fs::path> found{root / "README.md", root / "CONTRIBUTING.md"};
  for (const char* folder : {"docs", "data"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") {
        found.push_back(entry.path());
      }
    }
  }
  return found;
}

/// A command, how it should end, and the lines that the page shows of its output.
struct Shown {
  Arguments arguments;
  int exit_code{0};
  std::vector<std::string> output;
};

/// Commands are indented by four and start with the program's name; "# exit code N" says how one
/// ends. A fenced block without a language, anywhere before the next command, is output; "..." in
/// it stands for lines left out.
std::vector<Shown> shown_in(const fs::path& page) {
  static const std::regex command("    stillpoint (.*?)(?: +# (.*))?");
  static const std::regex ends("exit code ([0-9]+)");
  std::vector<Shown> found;
  std::istringstream lines(text_of(page));
  bool in_fence = false;
  bool in_output = false;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.rfind("```", 0) == 0) {
      in_fence = !in_fence;
      in_output = in_fence && line == "```";
    } else if (in_fence) {
      if (in_output && !found.empty() && !line.empty() && line != "...") {
        found.back().output.push_back(line);
      }
    } else if (std::regex_match(line, match, command)) {
      found.push_back({match[1].str().c_str(), 0, {}});
      const std::string comment = match[2];
      if (std::regex_search(comment, match, ends)) {
        found.back().exit_code = std::stoi(match[1]);
      }
    }
  }
  return found;
}

BOOST_FIXTURE_TEST_CASE(each_command_runs_and_prints_what_is_shown, Sandbox) {
  fs::create_directory_symlink(STILLPOINT_DATA_DIR, path("data"));
  write("dampers.csv", "f,delta\n0.26,0.37\n0.02,0.02\n");
  std::size_t commands = 0;
  std::map<Arguments, ProgramRun> answers;  // pages show some commands again
  for (const fs::path& page : pages()) {
    if (page.parent_path().filename() == "tour") {
      continue;  // tests/tour
    }
    for (const Shown& shown : shown_in(page)) {
      ++commands;
      const auto [known, is_new] = answers.try_emplace(shown.arguments);
      if (is_new) {
        known->second = run(shown.arguments);
      }
      const ProgramRun& answer = known->second;
      std::string line = page.filename().string() + ":";
      for (const std::string& argument : shown.arguments) {
        line += " " + argument;
      }
      BOOST_TEST(answer.exit_code == shown.exit_code, line << "\n" << answer.err);
      for (const std::string& output : shown.output) {
        BOOST_TEST(contains(answer.out + answer.err, output + "\n"), line << "\ndoes not print\n"
                                                                          << output);
      }
    }
  }
  BOOST_TEST(commands > 100U);
}

BOOST_AUTO_TEST_CASE(each_link_leads_to_a_file) {
  static const std::regex link("\\]\\(([^)#:]+)(?:#[^)]*)?\\)|src=\"([^\":]+)\"");
  for (const fs::path& page : pages()) {
    const std::string text = text_of(page);
    for (std::sregex_iterator match(text.begin(), text.end(), link), none; match != none; ++match) {
      const std::string target = (*match)[1].matched ? (*match)[1].str() : (*match)[2].str();
      BOOST_TEST(fs::exists(page.parent_path() / target), page.filename().string()
                                                              << " leads to " << target);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_readme_is_short) {
  std::istringstream text(text_of(root / "README.md"));
  const auto count = std::distance(std::istream_iterator<std::string>(text), {});
  BOOST_TEST(count <= 700);
}

BOOST_AUTO_TEST_SUITE_END()
