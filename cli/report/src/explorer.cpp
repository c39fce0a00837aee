// SPDX-License-Identifier: MIT
#include <stillpoint/report/browser.hpp>
#include <stillpoint/report/explorer.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string_view>
#include <system_error>

namespace stillpoint::report {

namespace {

namespace fs = std::filesystem;

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

std::optional<std::string> installed_explorer() {
  return beside_the_program("../share/stillpoint/stillpoint.html");
}

std::string explorer() {
  const auto installed = installed_explorer();
  const auto page = installed ? installed : beside_the_program("../../explorer/stillpoint.html");
  if (!page) {
    throw BrowserError(
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
