// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// What opens a page: $BROWSER, whose first command is taken, else xdg-open, else open. The words
/// of its command line, in which %s stands for the page. Throws UsageError where there is none.
[[nodiscard]] std::vector<std::string> browser();

/// A name for a page that nobody asked for by name, in a new directory for temporary files. The
/// directory goes if no page was written.
class TemporaryPage {
 public:
  /// Throws UsageError where there can be none.
  TemporaryPage();
  TemporaryPage(const TemporaryPage&) = delete;
  TemporaryPage& operator=(const TemporaryPage&) = delete;
  TemporaryPage(TemporaryPage&&) = delete;
  TemporaryPage& operator=(TemporaryPage&&) = delete;
  ~TemporaryPage();

  [[nodiscard]] std::string path() const { return (folder_ / "page.html").string(); }

 private:
  std::filesystem::path folder_;
};

/// Starts the browser with a page and does not wait for it. Throws UsageError where that fails.
void open_page(std::vector<std::string> browser, const std::string& path);

}  // namespace stillpoint::cli
