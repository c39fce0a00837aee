// SPDX-License-Identifier: MIT
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

namespace stillpoint::records {

std::string read_text_stream(std::string_view kind, std::string_view source, std::size_t largest,
                             std::FILE* file) {
  const FilePlace place{std::string(kind), std::string(source)};
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16U);
  for (;;) {
    const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file);
    if (std::ferror(file) != 0) {
      throw FileError::unreadable(place, errno);
    }
    text.append(buffer.data(), count);
    if (text.size() > largest) {
      throw FileError(place, fmt::format("is too large, must be at most {} bytes", largest));
    }
    if (count == 0) {
      return text;
    }
  }
}

std::string read_text_file(std::string_view kind, const std::string& path, std::size_t largest) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    throw FileError::unreadable({std::string(kind), path}, errno);
  }
  return read_text_stream(kind, path, largest, file.get());
}

std::string beside(const std::string& by, const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(by).parent_path();
  std::error_code unreachable;
  for (const std::size_t length : {name.size(), name.rfind('#')}) {
    const std::string file = name.substr(0, length);
    if (!file.empty() && fs::exists(folder / file, unreachable)) {
      // scenes/../records is records, unless scenes is a link.
      const fs::path plain = (folder / file).lexically_normal();
      const bool same = fs::equivalent(plain, folder / file, unreachable);
      return (same ? plain : folder / file).string() + name.substr(file.size());
    }
  }
  return name;
}

}  // namespace stillpoint::records
