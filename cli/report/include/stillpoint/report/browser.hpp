// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::report {

/// What opens a page: $BROWSER, whose first command is taken, else xdg-open, else open. The words
/// of its command line, in which %s stands for the page. Throws std::runtime_error if there is
/// none.
[[nodiscard]] std::vector<std::string> browser();

/// A name for a temporary page, in a new temporary directory. The directory is removed if no page
/// was written.
class TemporaryPage {
 public:
  /// Throws std::runtime_error if it cannot be created.
  TemporaryPage();
  TemporaryPage(const TemporaryPage&) = delete;
  TemporaryPage& operator=(const TemporaryPage&) = delete;
  ~TemporaryPage();

  [[nodiscard]] std::string path() const { return (folder_ / "page.html").string(); }

 private:
  std::filesystem::path folder_;
};

/// Starts the browser with a page and does not wait for it. Throws std::runtime_error if that
/// fails.
void open_page(std::vector<std::string> browser, const std::string& path);

/// The file of the page with the program in it, if it is installed with this program.
[[nodiscard]] std::optional<std::string> installed_explorer();

/// That, or the one that ./dev explorer made in the folder where this program was built. Throws
/// std::runtime_error if there is neither.
[[nodiscard]] std::string explorer();

/// A link to the page that shows a scene.
[[nodiscard]] std::string explorer_link(const std::string& page,
                                        const nlohmann::ordered_json& scene);

}  // namespace stillpoint::report
