// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace stillpoint::test {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::runtime_error("there is no file " + path.string());
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A directory that lives as long as the test. A fixture.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "stillpoint-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no directory for the test");
    }
    path_ = std::filesystem::canonical(name);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(std::string_view name) const { return path_ / name; }
  void write(std::string_view name, std::string_view text) const {
    std::ofstream file(path(name), std::ios::binary);
    if (!(file << text).flush()) {
      throw std::runtime_error("cannot write " + path(name).string());
    }
  }
  [[nodiscard]] std::string read(std::string_view name) const { return text_of(path(name)); }

 private:
  std::filesystem::path path_;
};

}  // namespace stillpoint::test
