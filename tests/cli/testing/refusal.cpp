// SPDX-License-Identifier: MIT
#include "refusal.hpp"
#include "testing/printing.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <ostream>

namespace stillpoint::cli_test {

std::ostream& operator<<(std::ostream& stream, const Wrong& wrong) {
  for (const std::string& argument : wrong.arguments) {
    stream << argument << ' ';
  }
  return stream << wrong.input.substr(0, 100);
}

void check_refusal(const ProgramRun& run, const Texts& says) {
  BOOST_TEST(run.exit_code == 2);
  BOOST_TEST(run.out.empty(), run.out.substr(0, 200));
  BOOST_TEST(run.err_lines().size() == 1U, run.err);
  BOOST_TEST(run.err.starts_with("stillpoint: "), run.err);
  BOOST_TEST(run.err.ends_with('\n'), run.err);
  check_contains(run.err, says);
}

void check_refused(const Sandbox& sandbox, const Wrong& wrong, const Surroundings& surroundings) {
  sandbox.write("old.json", "an old report\n");
  const auto before = sandbox.contents();
  Surroundings now = surroundings;
  now.input = wrong.input;
  check_refusal(sandbox.run(wrong.arguments, now), wrong.says);
  BOOST_TEST(sandbox.contents() == before);
  if (!wrong.arguments.empty() &&
      std::ranges::find(wrong.arguments, "--output") == wrong.arguments.end()) {
    Arguments with_output = wrong.arguments;
    const Arguments output{"--output", "old.json"};
    with_output.insert(with_output.begin() + 1, output.begin(), output.end());
    check_refusal(sandbox.run(with_output, now), wrong.says);
    BOOST_TEST(sandbox.contents() == before);
  }
}

}  // namespace stillpoint::cli_test
