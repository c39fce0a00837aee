// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/answers/answers.hpp>
#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/sheet.hpp>
#include <stillpoint/report/terminal.hpp>
#include <stillpoint/sweep/output.hpp>
#include <stillpoint/sweep/output_file.hpp>

namespace stillpoint::cli {

using sweep::Output;

/// The report as text, with its details if they are asked for.
template <class Report>
[[nodiscard]] std::string shown(const Report& report, const Settings& settings) {
  using report::Verbosity;
  return text(document(report, settings.flag("verbose") ? Verbosity::full : Verbosity::normal),
              {settings.text("title").value_or(""), report::terminal_has_colours()});
}

/// The report on standard output: JSON if asked for, else the document; nothing if `print` is
/// false. Each is made only if wanted.
template <class Report>
void print_report(const Report& report, const Settings& settings, Output& output,
                  bool print = true) {
  const auto path = settings.text("output");
  const bool print_json = settings.flag("json");
  const std::string written = print_json || path ? report::json_text(json(report)) : "";
  if (print) {
    output.print(print_json ? written : shown(report, settings));
  }
  if (path) {
    output.write_file("output", *path, written);
  }
}

/// Throws UsageError if the report is to be JSON, for the rows go to standard output already unless
/// `option` gives a file.
void require_no_json(const Settings& settings, std::string_view rows, std::string_view option);

/// The file of a figure in the directory of --svg.
[[nodiscard]] std::string svg_path(const std::string& directory, std::string_view figure);

/// Whether --html or --svg asks for a page or its figures.
[[nodiscard]] bool wants_page(const Settings& settings);

/// Makes the directory of --svg and checks that --html can be written, so that no long run is
/// wasted. Throws InputError and FileError.
void prepare_page(const Settings& settings);

/// Writes the page, with the title and the input from `settings`, and each figure alone, if they
/// are asked for. Throws InputError and FileError.
void write_page(const Settings& settings, Command command, figures::HtmlPage page, Output& output);

/// On standard error, for a reader who is not shown the document: what is a caution or a fault.
void remark_on(std::span<const design::Finding> findings,
               const std::optional<design::PhysicalInput>& physical);

[[nodiscard]] report::SheetFrame sheet_frame(const Settings& settings, Command command);

/// The sheet if --sheet asks for one, without which a remark says why there is none.
void write_sheet(const Settings& settings, const std::optional<std::string>& sheet, Output& output);

/// The page and the sheet if asked for, and the report; if `print` is false, only its file. Returns
/// the report's exit code.
template <class Report>
answers::ExitCode finish(const Report& report, Command command, const Settings& settings,
                         Output& output, bool print = true) {
  if (wants_page(settings)) {
    write_page(settings, command, page(report), output);
  }
  if constexpr (requires { sheet(report, report::SheetFrame()); }) {
    if (settings.has("sheet")) {
      write_sheet(settings, sheet(report, sheet_frame(settings, command)), output);
    }
  }
  print_report(report, settings, output, print);
  if constexpr (requires { findings(report); }) {
    if (settings.flag("json") || !print) {
      remark_on(findings(report), report.physical);
    }
  }
  return answers::exit_code(report);
}

/// The scene, a path or "-" for standard input, and the files that the options name. Throws
/// UsageError if two of them are standard input.
[[nodiscard]] std::vector<sweep::NamedFile> files_to_read(Command command, const Settings& settings,
                                                          const std::optional<std::string>& scene);

/// Throws records::FileError if a file that `command` would write is one that it reads, or is to be
/// written twice. Links are followed; a device or a pipe may be written to any number of times.
void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene);

}  // namespace stillpoint::cli
