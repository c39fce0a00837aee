// SPDX-License-Identifier: MIT
// Prints what is made from the options, and tables of the docs:
// stillpoint_docs
// man|bash|zsh|fish|scene-schema|motion-tables|sweep-columns|simulation-report-1|...

#include "generated_docs.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>

int main(int argc, char** argv) {
  try {
    namespace cli = stillpoint::cli;
    const std::map<std::string_view, std::string (*)()> makers{
        {"man", cli::man_page},
        {"bash", cli::bash_completion},
        {"zsh", cli::zsh_completion},
        {"fish", cli::fish_completion},
        {"scene-schema", cli::scene_schema},
        {"motion-tables", cli::motion_tables},
        {"sweep-columns", cli::sweep_columns_row}};
    const std::string_view what = argc == 2 ? argv[1] : "";
    const auto maker = makers.find(what);
    const std::string text = maker != makers.end() ? maker->second() : cli::report_schema(what);
    if (text.empty()) {
      std::fputs(
          "usage: stillpoint_docs "
          "man|bash|zsh|fish|scene-schema|motion-tables|sweep-columns|NAME\n"
          "NAME is that of a report, simulation-report-1 say, of which it prints the schema\n",
          stderr);
      return EXIT_FAILURE;
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    return written && std::fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stillpoint_docs: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
