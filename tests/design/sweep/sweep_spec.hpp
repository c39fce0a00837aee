// SPDX-License-Identifier: MIT
#pragma once

// Sweeps as a user of the library fills them, and a sink that keeps their rows.

#include "testing/folder.hpp"
#include "testing/test.hpp"

#include <stillpoint/sweep/run.hpp>
#include <stillpoint/sweep/spec.hpp>

namespace stillpoint::sweep_test {

using namespace stillpoint;
using namespace sweep;
using test::Folder;

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
  explicit MemorySink(const sweep::SweepState& found = {}) : RowSink(found) {}

  void write(std::string_view bytes) override { text += bytes; }
  void reached(const sweep::SweepState& state) override { rows = state.rows; }
  void finish(std::string_view header) override {
    finished = true;
    if (found().rows == 0) {
      text.replace(0, header.size(), header);
    }
    if (at_finish) {
      at_finish();
    }
  }
  sweep::LeftRows leave() override { return {rows}; }

  std::string text;
  std::int64_t rows{0};
  bool finished{false};
  std::function<void()> at_finish;
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

}  // namespace stillpoint::sweep_test
