// SPDX-License-Identifier: MIT
#pragma once

#include "record_texts.hpp"

namespace stillpoint::test {

/// The sample of a format, by the ending of its name.
inline std::string path_of(const std::string& name) {
  return std::string(STILLPOINT_DATA_DIR "/records/short_pulse.") + name;
}

inline const std::string& sample_text(const std::string& name) {
  static std::map<std::string, std::string> texts;
  std::string& text = texts[name];
  if (text.empty()) {
    std::ifstream file(path_of(name), std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(file), {});
    BOOST_TEST_REQUIRE(!text.empty());
  }
  return text;
}

/// With the first `old` replaced, which must be there.
inline std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  BOOST_TEST_REQUIRE(at != std::string::npos, "no " << old);
  return text.replace(at, old.size(), now);
}

}  // namespace stillpoint::test
