// SPDX-License-Identifier: MIT
#include <stillpoint/report/browser.hpp>

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <system_error>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace stillpoint::report {

namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// By its path, or by its name in $PATH.
bool can_be_run(const std::string& program) {
  const std::string folders = program.find('/') == std::string::npos ? variable("PATH") : ".";
  return !program.empty() &&
         std::ranges::any_of(records::split(folders, ':'), [&program](std::string_view folder) {
           std::error_code unreachable;
           const fs::path path = fs::path(folder) / program;
           return fs::is_regular_file(path, unreachable) && ::access(path.c_str(), X_OK) == 0;
         });
}

/// A file by its path from the folder of this program.
std::optional<std::string> beside_the_program(const char* path) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path page = (program.parent_path() / path).lexically_normal();
  return !error && fs::is_regular_file(page, error) ? std::optional(page.string()) : std::nullopt;
}

/// A text for a URL: everything but letters, digits and `plain` as %XX.
std::string encoded(std::string_view text, std::string_view plain) {
  std::string result;
  for (const char c : text) {
    const bool stays = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       plain.find(c) != std::string_view::npos;
    result += stays ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return result;
}

/// As on the command line: a range as LOW:HIGH.
std::string text(const nlohmann::ordered_json& value) {
  return value.is_string()  ? value.get<std::string>()
         : value.is_array() ? value.front().dump() + ":" + value.back().dump()
                            : value.dump();
}

}  // namespace

std::vector<std::string> browser() {
  const std::string commands = variable("BROWSER") + ":xdg-open:open";
  for (const std::string_view command : records::split(commands, ':')) {
    const auto words = records::words_of(command, " ");
    if (!words.empty() && can_be_run(std::string(words.front()))) {
      return {words.begin(), words.end()};
    }
  }
  throw std::runtime_error(
      "open: no browser was found: set BROWSER to a program, or write the page with --html FILE");
}

TemporaryPage::TemporaryPage() {
  std::error_code error;
  std::string made = (fs::temp_directory_path(error) / "stillpoint-XXXXXX").string();
  if (!error && ::mkdtemp(made.data()) == nullptr) {
    error.assign(errno, std::generic_category());
  }
  if (error) {
    throw std::runtime_error(
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
    throw std::runtime_error(
        fmt::format("open: {} cannot be started: {}", arguments.front(), std::strerror(error)));
  }
}

std::optional<std::string> installed_explorer() {
  return beside_the_program("../share/stillpoint/stillpoint.html");
}

std::string explorer() {
  const auto installed = installed_explorer();
  const auto page = installed ? installed : beside_the_program("../../explorer/stillpoint.html");
  if (!page) {
    throw std::runtime_error(
        "explore: the page is not installed: ./dev explorer in the source directory makes it");
  }
  return *page;
}

std::string explorer_link(const std::string& page, const nlohmann::ordered_json& scene) {
  std::string link = "file://" + encoded(page, "/-_.~");
  char separator = '#';
  for (const auto& [name, value] : scene.items()) {
    link += separator + encoded(name, "-") + '=' + encoded(text(value), "-_.~:+");
    separator = '&';
  }
  return link;
}

}  // namespace stillpoint::report
