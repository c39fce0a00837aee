// SPDX-License-Identifier: MIT
// What other compilers and libraries ask of the sources: ./dev portability shows that it is enough.
#include "sources.hpp"

#include <nlohmann/json.hpp>

BOOST_AUTO_TEST_SUITE(portability_test)

using namespace stillpoint::test;

/// Since fmt 11 it is nowhere else.
BOOST_AUTO_TEST_CASE(who_joins_includes_the_header_for_it) {
  for (const fs::path& file : sources()) {
    const std::string text = text_of(file);
    BOOST_TEST((!contains(text, "fmt::join") || contains(text, "<fmt/ranges.h>") ||
                contains(text, "\"option_facts.hpp\"")),
               file.lexically_relative(root));
  }
}

/// A new compiler's new warning must keep nobody from building; .ci/run asks for errors.
BOOST_AUTO_TEST_CASE(only_we_treat_warnings_as_errors) {
  const auto presets = nlohmann::json::parse(text_of(root / "CMakePresets.json"));
  for (const auto& preset : presets["configurePresets"]) {
    BOOST_TEST(
        !preset.value("cacheVariables", nlohmann::json::object()).contains("STILLPOINT_WERROR"),
        preset["name"]);
  }
  check_contains(text_of(root / "CMakeLists.txt"),
                 {"option(STILLPOINT_WERROR \"Treat warnings as errors\" OFF)"});
  check_contains(text_of(root / ".ci/run"), {"export STILLPOINT_WERROR=ON"});
}

BOOST_AUTO_TEST_SUITE_END()
