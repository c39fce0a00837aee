// SPDX-License-Identifier: MIT
// Which sweep a checkpoint is of.

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/sweep/checkpoint.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace stillpoint::sweep {

namespace {

using nlohmann::ordered_json;

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

Checkpoint beginning(const SweepSpec& spec) {
  if (!ordered_json::parse(spec.identity, nullptr, false).is_object()) {
    throw InputError("identity", spec.identity, "must be a JSON object");
  }
  return {.path = spec.output.value_or(""),
          .task = spec.identity,
          .kind = spec.kind,
          .part = spec.part.value_or(SweepPart()),
          .whole = {entries(spec).value_or(0), spec.listed ? spec.listed->digest : 0}};
}

std::string difference(const Checkpoint& one, const Checkpoint& other) {
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

}  // namespace stillpoint::sweep
