// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/part_label.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

namespace {

using nlohmann::ordered_json;

[[noreturn]] void refuse_part(const PartLabel& label, std::string_view why) {
  throw records::FileError({.kind = "part", .path = label.path}, why);
}

/// The first difference of two tasks.
std::string difference_of_tasks(const std::string& one, const std::string& other) {
  const ordered_json was = ordered_json::parse(one);
  const ordered_json is = ordered_json::parse(other);
  const auto text = [](const ordered_json& task, const std::string& key) {
    return records::shortened(task.contains(key) ? task.at(key).dump() : "nothing",
                              records::longest_word);
  };
  for (const ordered_json* const task : {&was, &is}) {
    for (const auto& [key, value] : task->items()) {
      if (!was.contains(key) || !is.contains(key) || was.at(key) != is.at(key)) {
        return fmt::format("{} was {}, is {}", key, text(was, key), text(is, key));
      }
    }
  }
  return {};
}

}  // namespace

std::optional<std::int64_t> PartLabel::rows() const {
  const bool exists = 1 <= part.number && part.number <= part.count &&
                      part.count <= most_sweep_parts && whole.entries >= 0;
  return exists ? std::optional(range_of(part, whole.entries).count) : std::nullopt;
}

std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                        std::string_view version) {
  ordered_json result;
  result["version"] = version;
  result["kind"] = name(spec.kind);
  result["format"] = name(spec.format);
  for (const Quantity column : spec.columns) {
    result["columns"].push_back(name(column));
  }
  result["list"] = spec.list != nullptr;
  result.update(ordered_json::parse(inputs));
  result["record_digest"] = digest(spec.excitation);
  for (const NamedRecord& record : spec.records) {
    result["records"].push_back({{"name", record.name}, {"digest", digest(record.record)}});
  }
  if (!spec.parts.empty()) {
    result["catalogue_digest"] = digest(spec.parts);
  }
  return result.dump();
}

PartLabel label_of(const SweepSpec& spec) {
  if (!ordered_json::parse(spec.identity, nullptr, false).is_object()) {
    throw InputError("identity", spec.identity, "must be a JSON object");
  }
  return {spec.output.value_or(""),
          spec.part.value_or(SweepPart()),
          spec.identity,
          {entries(spec).value_or(0), spec.listed ? spec.listed->digest : 0}};
}

std::string difference(const PartLabel& one, const PartLabel& other) {
  if (one.task != other.task) {
    return difference_of_tasks(one.task, other.task);
  }
  if (one.part.count != other.part.count) {
    return fmt::format("it is part {}, not {}", text(other.part), text(one.part));
  }
  if (one.whole.entries != other.whole.entries) {
    return fmt::format("the number of entries was {} and is now {}", one.whole.entries,
                       other.whole.entries);
  }
  return one.whole.digest == other.whole.digest ? "" : "the list has changed";
}

bool is_that_part(const PartLabel& found, const PartLabel& wanted) {
  if (!difference(found, wanted).empty()) {
    return false;
  }
  if (found.part != wanted.part) {
    throw records::FileError(
        {.kind = "output", .path = wanted.path},
        fmt::format("is part {} of this sweep: give each part its own file, for instance with "
                    "{{part}} in its name",
                    text(found.part)));
  }
  return true;
}

void PartOrder::add(PartLabel label) {
  if (!labels_.empty()) {
    const PartLabel& first = labels_.front();
    if (const std::string differs = difference(first, label); !differs.empty()) {
      refuse_part(label,
                  fmt::format("belongs to a different sweep from {}: {}", first.path, differs));
    }
    label.task.clear();  // that of the first is enough, and may be long
  }
  labels_.push_back(std::move(label));
}

std::vector<std::size_t> PartOrder::places() const {
  if (labels_.empty()) {
    throw InputError::missing("part", "name the files of all parts");
  }
  std::vector<std::size_t> places(labels_.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const auto number = [this](std::size_t place) { return labels_[place].part.number; };
  std::ranges::stable_sort(places, {}, number);
  std::int64_t next = 1;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PartLabel& label = labels_[places[i]];
    if (i > 0 && label.part == labels_[places[i - 1]].part) {
      refuse_part(label, fmt::format("is part {}, and so is {}", text(label.part),
                                     labels_[places[i - 1]].path));
    }
    next += label.part.number == next ? 1 : 0;
  }
  const std::int64_t count = labels_.front().part.count;
  if (next <= count) {
    const std::int64_t missing = count - std::ssize(places);
    throw InputError(
        "part", text(SweepPart{next, count}),
        missing == 1 ? "is missing" : fmt::format("is missing, the first of {}", missing));
  }
  return places;
}

}  // namespace stillpoint::sweep
