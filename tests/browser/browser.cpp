// SPDX-License-Identifier: MIT
#include "browser.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <sstream>

namespace stillpoint::browser_test {

namespace {

void require(bool success, const char* what, int error = errno) {
  if (!success) {
    throw std::system_error(error, std::generic_category(), what);
  }
}

/// Runs the command with its output in two files.
int run(std::vector<std::string> words, const std::string& out, const std::string& err) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  require(::posix_spawn_file_actions_init(&actions) == 0, "posix_spawn");
  constexpr int anew = O_WRONLY | O_CREAT | O_TRUNC;
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), anew, 0644);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), anew, 0644);
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  require(error == 0, arguments[0], error);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    require(errno == EINTR, "waitpid");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

Visit visit(const cli_test::Sandbox& sandbox, const std::string& file,
            const cli_test::Arguments& options) {
  // `timeout` ends the browser together with the processes that it started. The sandbox of the
  // browser itself needs rights that a container lacks; these pages are our own.
  const cli_test::Arguments command{"timeout",
                                    "-k",
                                    "5",
                                    "60",
                                    STILLPOINT_BROWSER,
                                    "--headless",
                                    "--no-sandbox",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--disable-dev-shm-usage",
                                    "--enable-logging=stderr",
                                    "--user-data-dir=" + sandbox.path("profile").string()};
  std::vector<std::string> words = command + options;
  words.push_back("file://" + sandbox.path(file).string());
  Visit result;
  result.exit_code =
      run(std::move(words), sandbox.path("browser.out"), sandbox.path("browser.err"));
  result.out = sandbox.read("browser.out");
  std::istringstream log(sandbox.read("browser.err"));
  for (std::string line; std::getline(log, line);) {
    if (line.find("CONSOLE") != std::string::npos) {
      result.console += line + '\n';
    }
  }
  return result;
}

}  // namespace stillpoint::browser_test
