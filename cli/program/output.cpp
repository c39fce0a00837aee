// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace stillpoint::cli {

namespace {

bool coloured() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool refused = no_color != nullptr && *no_color != '\0';
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return !refused && !dumb && ::isatty(STDOUT_FILENO) == 1;
}

}  // namespace

std::string shown(const report::Document& document, const Settings& settings) {
  return text(document, {.title = settings.text("title").value_or(""),
                         .coloured = coloured(),
                         .verbosity = settings.flag("verbose") ? report::Verbosity::full
                                                               : report::Verbosity::normal});
}

}  // namespace stillpoint::cli
