// SPDX-License-Identifier: MIT
#include <stillpoint/report/browser.hpp>

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace stillpoint::report {

namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_program(const std::string& path) {
  std::error_code unreachable;
  return fs::is_regular_file(path, unreachable) && ::access(path.c_str(), X_OK) == 0;
}

/// By its path, or by its name in $PATH.
bool can_be_run(const std::string& program) {
  if (program.find('/') != std::string::npos) {
    return is_program(program);
  }
  const std::string path = variable("PATH");
  return !program.empty() &&
         std::ranges::any_of(records::split(path, ':'), [&program](std::string_view folder) {
           return is_program(fmt::format("{}/{}", folder, program));
         });
}

}  // namespace

std::vector<std::string> browser() {
  const std::string chosen = variable("BROWSER");
  for (const std::string_view command : records::split(chosen, ':')) {
    const auto words = records::words_of(command, " ");
    std::vector<std::string> asked(words.begin(), words.end());
    if (!asked.empty() && can_be_run(asked.front())) {
      return asked;
    }
  }
  for (const char* const usual : {"xdg-open", "open"}) {
    if (can_be_run(usual)) {
      return {usual};
    }
  }
  throw BrowserError(
      "open: no browser was found: set BROWSER to a program, or write the page with --html FILE");
}

TemporaryPage::TemporaryPage() {
  std::error_code error;
  std::string made = (fs::temp_directory_path(error) / "stillpoint-XXXXXX").string();
  if (!error && ::mkdtemp(made.data()) == nullptr) {
    error.assign(errno, std::generic_category());
  }
  if (error) {
    throw BrowserError(
        fmt::format("open: no temporary page can be made: {}: set TMPDIR to a folder for it, or "
                    "write the page with --html FILE",
                    error.message()));
  }
  folder_ = made;
}

TemporaryPage::~TemporaryPage() {
  std::error_code has_a_page;
  fs::remove(folder_, has_a_page);
}

void open_page(std::vector<std::string> browser, const std::string& path) {
  const std::string page = fs::absolute(path).string();
  bool placed = false;
  for (std::string& word : browser) {
    if (const std::size_t place = word.find("%s"); place != std::string::npos) {
      word.replace(place, 2, page);
      placed = true;
    }
  }
  if (!placed) {
    browser.push_back(page);
  }
  std::vector<char*> arguments;
  arguments.reserve(browser.size() + 1);
  for (std::string& word : browser) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  // It outlives this program, whose output must not wait for it.
  ::posix_spawn_file_actions_t actions{};
  ::posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  ::pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw BrowserError(
        fmt::format("open: {} cannot be started: {}", arguments.front(), std::strerror(error)));
  }
}

}  // namespace stillpoint::report
