// SPDX-License-Identifier: MIT
#pragma once

#include "testing/folder.hpp"
#include "testing/test.hpp"

namespace stillpoint::test {

inline const fs::path root = fs::path(STILLPOINT_DATA_DIR).parent_path();

/// The C++ that users run, with what completes the library of the page.
inline std::vector<fs::path> sources() {
  std::vector<fs::path> found;
  for (const char* layer : {"core", "design", "cli"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".hpp" || path.extension() == ".cpp" ||
          path.parent_path().filename() == "standard") {
        found.push_back(path);
      }
    }
  }
  return found;
}

}  // namespace stillpoint::test
