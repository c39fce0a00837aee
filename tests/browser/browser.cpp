// SPDX-License-Identifier: MIT
#include "browser.hpp"

namespace stillpoint::browser_test {

Visit visit(const cli_test::Sandbox& sandbox, const std::string& file,
            const cli_test::Arguments& options) {
  // Into files, which processes that the browser leaves behind do not keep open for the reader.
  // `timeout` ends it together with those. The sandbox of the browser itself needs rights that a
  // container lacks; these pages are our own.
  const cli_test::Arguments command{"-c",
                                    "timeout -k 5 60 \"$@\" > browser.out 2> browser.err",
                                    "sh",
                                    STILLPOINT_BROWSER,
                                    "--headless",
                                    "--no-sandbox",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--disable-dev-shm-usage",
                                    "--enable-logging=stderr",
                                    "--user-data-dir=" + sandbox.path("profile").string()};
  const cli_test::Arguments address{"file://" + sandbox.path(file).string()};
  Visit result;
  result.exit_code = sandbox.run(command + options + address, {.program = "/bin/sh"}).exit_code;
  result.out = sandbox.read("browser.out");
  for (const std::string& line : cli_test::lines_of(sandbox.read("browser.err"))) {
    result.console += cli_test::contains(line, "CONSOLE") ? line + '\n' : "";
  }
  return result;
}

}  // namespace stillpoint::browser_test
