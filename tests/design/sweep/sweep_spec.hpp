// SPDX-License-Identifier: MIT
#pragma once

// Sweeps as a user of the library fills them, and a sink that keeps their rows.

#include <stillpoint/sweep/run.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::sweep_test {

using sweep::Axis;
using sweep::Quantity;

/// Free motions from v0 = 1 with p = 1 over the given axes, with times.
inline sweep::SweepSpec free_spec(Axis f, Axis delta) {
  sweep::SweepSpec spec;
  spec.axes = {{Quantity::v0, Axis({1})},
               {Quantity::p, Axis({1})},
               {Quantity::x0, Axis({0})},
               {Quantity::f, std::move(f)},
               {Quantity::delta, std::move(delta)}};
  spec.columns = default_columns(spec, true);
  return spec;
}

/// Keeps what it is given, as if the first rows had been written before.
class MemorySink : public sweep::RowSink {
 public:
  explicit MemorySink(const sweep::SweepState& found = {}) : found_(found) {}

  [[nodiscard]] const sweep::SweepState& found() const override { return found_; }
  void write(std::string_view bytes) override { text += bytes; }
  void reached(const sweep::SweepState& state) override { rows = state.rows; }
  void finish(const sweep::SweepState& /*state*/, std::string_view header) override {
    finished = true;
    text.replace(0, found_.rows == 0 ? header.size() : 0, found_.rows == 0 ? header : "");
    if (at_finish) {
      at_finish();
    }
  }
  sweep::LeftRows leave() override { return {rows}; }

  std::string text;
  std::int64_t rows{0};
  bool finished{false};
  std::function<void()> at_finish;

 private:
  sweep::SweepState found_;
};

/// The fields of each line of CSV.
inline std::vector<std::vector<std::string>> fields_of(const std::string& csv) {
  std::vector<std::vector<std::string>> lines{{""}};
  for (const char c : csv) {
    if (c == '\n') {
      lines.push_back({""});
    } else if (c == ',') {
      lines.back().emplace_back();
    } else {
      lines.back().back() += c;
    }
  }
  lines.pop_back();
  return lines;
}

/// A directory that lives as long as the test. A fixture.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "sweep_tests.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no directory for the test");
    }
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(Folder&&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::filesystem::exists(path(name));
  }

 private:
  std::filesystem::path path_;
};

}  // namespace stillpoint::sweep_test
