// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/output.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace stillpoint::cli {

using sweep::Output;

/// The document as text, under the title of the settings; in colour only where standard output is a
/// terminal, NO_COLOR is not set (or empty) and TERM is not "dumb".
[[nodiscard]] std::string shown(const report::Document& document, const Settings& settings);

/// The report on standard output: JSON where it was asked for, else the document; and where
/// `print` is false nothing. Each is made only if wanted.
template <class Report>
void print_report(const Report& report, const Settings& settings, Output& output,
                  bool print = true) {
  constexpr int indent = 2;
  const auto path = settings.text("output");
  const bool print_json = settings.flag("json");
  const std::string written = print_json || path ? json(report).dump(indent) + "\n" : "";
  if (print) {
    output.print(print_json ? written : shown(document(report), settings));
  }
  if (path) {
    output.write_file("output", *path, written);
  }
}

}  // namespace stillpoint::cli
