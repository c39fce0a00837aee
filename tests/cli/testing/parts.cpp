// SPDX-License-Identifier: MIT
#include "parts.hpp"

#include <fmt/format.h>

namespace stillpoint::cli_test {

Parts::Parts(std::string extension) : extension_(std::move(extension)) {}

ProgramRun Parts::part(const Arguments& task, int i, int n, const Arguments& more,
                       const std::string& extension) const {
  const std::string file = "{part}." + (extension.empty() ? extension_ : extension);
  return run(task +
             Arguments{"--part", fmt::format("{}/{}", i, n), "--output", file, "--threads",
                       std::to_string(1 + i % 3)} +
             more);
}

Arguments Parts::split(const Arguments& task, int n, const std::string& extension) const {
  Arguments names;
  for (int i = n; i >= 1; --i) {
    const ProgramRun answer = part(task, i, n, {}, extension);
    BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
    names.push_back(fmt::format("{:0{}}-of-{}.{}", i, std::to_string(n).size(), n,
                                extension.empty() ? extension_ : extension));
  }
  return names;
}

ProgramRun Parts::merge(const Arguments& parts, const Arguments& more) const {
  return run(Arguments{"sweep", "merge", "merged"} + parts + more);
}

void Parts::check_merged(const Arguments& task, int n, const std::string& extension) const {
  BOOST_TEST_CONTEXT(n << " parts, " << extension) {
    const std::string whole = "whole." + (extension.empty() ? extension_ : extension);
    succeed(task + Arguments{"--output", whole});
    const ProgramRun answer = merge(split(task, n, extension));
    BOOST_TEST(answer.exit_code == 0, answer.err);
    BOOST_TEST((read("merged") == read(whole)));
  }
}

void Parts::check_refused(const Arguments& parts, const Texts& says, const Arguments& more) const {
  const auto before = contents();
  check_refusal(merge(parts, more), says);
  BOOST_TEST(contents() == before);
}

}  // namespace stillpoint::cli_test
