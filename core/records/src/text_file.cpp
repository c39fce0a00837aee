// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include "printable.hpp"
#include "settings.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

namespace stillpoint::cli {

namespace {

[[noreturn]] void refuse(std::string_view kind, std::string_view source, int error) {
  throw UsageError(fmt::format("{} {}: cannot be read: {}", kind, shortened(source, longest_path),
                               std::strerror(error)));
}

}  // namespace

std::string read_text_stream(std::string_view kind, std::string_view source, std::size_t largest,
                             std::FILE* file) {
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16U);
  for (;;) {
    const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file);
    if (std::ferror(file) != 0) {
      refuse(kind, source, errno);
    }
    text.append(buffer.data(), count);
    if (text.size() > largest) {
      throw UsageError(
          fmt::format("{} {}: is too large, must be at most {} bytes", kind, source, largest));
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
    refuse(kind, path, errno);
  }
  return read_text_stream(kind, path, largest, file.get());
}

}  // namespace stillpoint::cli
