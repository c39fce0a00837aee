// SPDX-License-Identifier: MIT
// Prints what is made from the options, and tables of the docs:
// stillpoint_docs man|bash|zsh|fish|scene-schema|tolerance-tables

#include "generated_docs.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <string_view>

int main(int argc, char** argv) {
  try {
    namespace cli = stillpoint::cli;
    const std::map<std::string_view, std::string (*)()> makers{
        {"man", cli::man_page},
        {"bash", cli::bash_completion},
        {"zsh", cli::zsh_completion},
        {"fish", cli::fish_completion},
        {"scene-schema", cli::scene_schema},
        {"tolerance-tables", cli::tolerance_tables}};
    const auto maker = makers.find(argc == 2 ? argv[1] : "");
    if (maker == makers.end()) {
      std::fputs("usage: stillpoint_docs man|bash|zsh|fish|scene-schema|tolerance-tables\n",
                 stderr);
      return EXIT_FAILURE;
    }
    const std::string text = maker->second();
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    return written && std::fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stillpoint_docs: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
