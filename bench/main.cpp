// SPDX-License-Identifier: MIT

// Speed against error: this project's kernel and the methods that others would use, on the scenes
// of data/reference. Writes performance.json, .md, .svg and .html.

#include "comparison.hpp"
#include "reports.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace stillpoint::bench {

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) {
    throw std::runtime_error(path.string() + " could not be written");
  }
}

int run(int count, char** arguments) {
  std::string reference;
  std::filesystem::path folder;
  peers::MeasureOptions options;
  CLI::App app("Speed against error, on every scene, in one run");
  app.add_option("--reference", reference, "folder of the reference tables")->required();
  app.add_option("--out", folder, "folder for performance.json, .md, .svg and .html")->required();
  app.add_option("--batches", options.batches, "batches per call")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, count, arguments);

  const Comparison comparison = compare(peers::reference_scenes(reference), options);
  const std::string page = markdown_report(comparison);
  std::filesystem::create_directories(folder);
  write(folder / "performance.json", json_report(comparison));
  write(folder / "performance.md", page);
  write(folder / "performance.svg", chart(comparison));
  write(folder / "performance.html", chart_page(comparison));
  fmt::print("{}", page);
  fmt::print(stderr, "bench: {:.0f} s; written into {}\n", comparison.seconds, folder.string());
  return 0;
}

}  // namespace

}  // namespace stillpoint::bench

int main(int count, char** arguments) {
  try {
    return stillpoint::bench::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench: {}\n", error.what());
    return 1;
  }
}
