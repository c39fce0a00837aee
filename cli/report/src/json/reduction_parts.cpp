// SPDX-License-Identifier: MIT
// Reads the parts of a reduced sweep, as reduction.cpp writes them, and joins them.

#include "json/sweep_parts.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/report/reduction.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

[[noreturn]] void refuse_part(const std::string& path) {
  throw records::FileError({.kind = "part", .path = path},
                           "is not a complete part of a reduced sweep: it is another kind of file, "
                           "was cut short, or has changed");
}

void read(const ordered_json& counts, sweep::SweepState::Counts& to) {
  sweep::read_integers(std::vector<ordered_json>(counts.begin(), counts.end()), to);
}

ReductionReport report_from(ordered_json document) {
  ReductionReport report;
  auto& [label, kind, state, found] = report;
  found = std::move(document);
  label.task = found.at("task").dump();
  sweep::read_integers(found.at("part").at("number"), label.part.number);
  sweep::read_integers(found.at("part").at("count"), label.part.count);
  sweep::read_integers(found.at("entries"), label.whole.entries);
  sweep::read_integers(found.at("list_digest"), label.whole.digest);
  kind = parse<sweep::SweepKind>(found.at("kind").get<std::string>()).value();
  sweep::read_integers(found.at("rows"), state.rows);
  if (kind == sweep::SweepKind::design) {
    sweep::read_integers(found.at("feasible"), state.feasible);
  } else {
    read(found.at("outcomes"), state.outcomes);
    read(found.at("locked_outcomes"), state.locked_outcomes);
  }
  return report;
}

/// All numbers that further entries change are counts, but for those of rows.
void add_counts(ordered_json& total, const ordered_json& more) {
  constexpr auto others = std::to_array<std::string_view>(
      {"part", "entries", "least", "largest", "edges", "best", "list_digest", "task"});
  if (total.is_number()) {
    total = total.get<std::int64_t>() + more.get<std::int64_t>();
  } else if (total.is_structured()) {
    auto other = more.begin();
    for (auto now = total.begin(); now != total.end(); ++now, ++other) {
      if (total.is_array() || std::ranges::find(others, now.key()) == others.end()) {
        add_counts(*now, *other);
      }
    }
  }
}

/// Joins two lists of rows with the best by that column in front; of equals the first of the sweep,
/// and what is no row behind all.
void join(ordered_json::array_t& rows, const ordered_json::array_t& more, const std::string& column,
          bool largest) {
  const auto place = [&](const ordered_json& row) {
    const double value = row.is_null() ? std::numeric_limits<double>::infinity()
                                       : row.at(column).get<double>() * (largest ? -1 : 1);
    return std::pair(value, row.is_null() ? 0 : row.at("entry").get<std::int64_t>());
  };
  const auto middle = static_cast<std::ptrdiff_t>(rows.size());
  rows.insert(rows.end(), more.begin(), more.end());
  std::ranges::inplace_merge(rows, rows.begin() + middle, {}, place);
}

void add(ordered_json& total, const ordered_json& more) {
  add_counts(total, more);
  for (std::size_t i = 0; i < total.at("columns").size(); ++i) {
    ordered_json& column = total.at("columns")[i];
    for (const char* const which : {"least", "largest"}) {
      ordered_json::array_t rows{column.at(which)};
      join(rows, {more.at("columns")[i].at(which)}, column.at("column"),
           which == std::string_view("largest"));
      column[which] = rows.front();
    }
  }
  for (std::size_t i = 0; i < total.at("best").size(); ++i) {
    ordered_json& best = total.at("best")[i];
    auto& rows = best.at("rows").get_ref<ordered_json::array_t&>();
    join(rows, more.at("best")[i].at("rows"), best.at("column"), best.at("order") == "largest");
    rows.resize(std::min(rows.size(), best.at("most").get<std::size_t>()));
  }
}

}  // namespace

std::uint64_t digest_of(const ordered_json& report) {
  sweep::Digest digest;
  for (const char byte : report.dump()) {
    digest.add(std::uint64_t{static_cast<unsigned char>(byte)});
  }
  return digest.value();
}

bool is_reduction(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return file.get() == '{';
}

ReductionReport read_reduction(const std::string& path) {
  constexpr std::size_t largest_file = std::size_t{1} << 30U;
  cancellation_point();
  if (std::error_code unknown; std::filesystem::exists(path, unknown) && !is_reduction(path)) {
    refuse_part(path);
  }
  const std::string text = records::read_text_file("part", path, largest_file);
  try {
    sweep::require_json_object(text, {.kind = "part", .path = path});
    auto document = ordered_json::parse(text);
    const ordered_json digest = document.at("digest");
    document.erase("digest");
    if (document.at("schema") != reduction_schema || digest != digest_of(document)) {
      throw std::runtime_error("not a part");
    }
    ReductionReport report = report_from(std::move(document));
    report.label.path = path;
    if (report.label.rows() != report.state.rows) {
      throw std::runtime_error("not that part");
    }
    return report;
  } catch (const std::exception&) {
    refuse_part(path);
  }
}

std::optional<ReductionReport> find_reduction(const sweep::SweepSpec& spec) {
  if (!spec.part) {
    if (spec.resume) {
      throw InputError("resume", "true", "cannot be combined with reduce: give --part as well");
    }
    return std::nullopt;
  }
  auto found = sweep::find_part(label_of(spec), read_reduction);
  return spec.resume ? std::move(found) : std::nullopt;
}

ordered_json merged(const std::vector<std::string>& parts) {
  sweep::PartOrder order;
  ordered_json total;
  for (const std::string& path : parts) {
    ReductionReport part = read_reduction(path);
    order.add(std::move(part.label));
    if (total.is_null()) {
      total = std::move(part.found);
    } else {
      add(total, part.found);
    }
  }
  static_cast<void>(order.places());
  total["part"] = nullptr;
  total["digest"] = nullptr;
  return total;
}

}  // namespace stillpoint::report
