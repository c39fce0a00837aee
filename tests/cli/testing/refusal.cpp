// SPDX-License-Identifier: MIT
#include "refusal.hpp"
#include "testing/printing.hpp"
#include "testing/unescaped.hpp"

#include <algorithm>

namespace stillpoint::cli_test {

std::ostream& operator<<(std::ostream& stream, const Wrong& wrong) {
  for (const std::string& argument : wrong.arguments) {
    stream << argument << ' ';
  }
  return stream << wrong.input.substr(0, 100);
}

std::vector<Wrong> commands_in(const std::string& file) {
  std::ifstream lines(STILLPOINT_COMMANDS "/" + file);
  BOOST_TEST_REQUIRE(lines.good(), file);
  std::map<std::string, std::string> files;
  std::map<std::string, std::string> tasks;
  std::vector<Wrong> all;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("$ ")) {
      const std::size_t word = std::min(line.find(' ', 2), line.size());
      const auto task = tasks.find(line.substr(2, word - 2));
      line = task == tasks.end() ? line.substr(2) : task->second + line.substr(word);
      all.push_back({line.c_str(), {}, {}, files});
      std::ranges::transform(all.back().arguments, all.back().arguments.begin(), test::unescaped);
    } else if (line.starts_with("  < ")) {
      all.back().input = test::unescaped(line.substr(4));
    } else if (line.starts_with("  ")) {
      all.back().says.push_back(test::unescaped(line.substr(2)));
    } else if (line.starts_with("folder ")) {
      files[line.substr(7)] = "/";
    } else if (line.starts_with("task ")) {
      const std::size_t name = line.find(' ', 5);
      tasks[line.substr(5, name - 5)] = line.substr(name + 1);
    } else if (line.starts_with("file ") || line.starts_with("link ")) {
      const std::size_t name = line.find(' ', 5);
      std::string& text = files[line.substr(5, name - 5)] = test::unescaped(line.substr(name + 1));
      text.insert(0, line.starts_with("link ") ? "-> " : "");
    } else {
      BOOST_TEST_REQUIRE((line.empty() || line.starts_with('#')), file << ": " << line);
    }
  }
  return all;
}

void check_refusal(const ProgramRun& run, const Texts& says) {
  BOOST_TEST(run.exit_code == 2);
  BOOST_TEST(run.out.empty(), run.out.substr(0, 200));
  BOOST_TEST(run.err_lines().size() == 1U, run.err);
  BOOST_TEST(run.err.starts_with("stillpoint: "), run.err);
  BOOST_TEST(run.err.ends_with('\n'), run.err);
  check_contains(run.err, says);
  BOOST_TEST(run.err.size() < 600U, run.err.substr(0, 1000));  // quoted in part
}

void write_files(const Sandbox& sandbox, const Wrong& wrong) {
  for (const auto& [name, text] : wrong.files) {
    if (text == "/") {
      std::filesystem::create_directory(sandbox.path(name));
    } else if (text.starts_with("-> ")) {
      std::filesystem::create_symlink(text.substr(3), sandbox.path(name));
    } else {
      sandbox.write(name, text);
    }
  }
}

void check_refused(const Sandbox& sandbox, const Wrong& wrong) {
  write_files(sandbox, wrong);
  sandbox.write("old.csv", "an old report\n");
  const auto before = sandbox.contents();
  Arguments with_output = wrong.arguments;
  if (!with_output.empty() && std::ranges::find(with_output, "--output") == with_output.end()) {
    const Arguments output{"--output", "old.csv"};
    with_output.insert(with_output.begin() + 1, output.begin(), output.end());
  }
  check_refusal(sandbox.run(with_output, {.input = wrong.input}), wrong.says);
  BOOST_TEST(sandbox.contents() == before);
}

}  // namespace stillpoint::cli_test
