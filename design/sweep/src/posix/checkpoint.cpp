// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include "seal.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/json_text.hpp>
#include <stillpoint/sweep/output_file.hpp>
#include <stillpoint/sweep/sink.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace stillpoint::sweep {

namespace {

using nlohmann::ordered_json;
using records::longest_word;
using records::shortened;

constexpr auto schema = "stillpoint/sweep-checkpoint/1";
constexpr std::size_t largest = std::size_t{1} << 26U;  // a task holds axes, which may be long

ordered_json task_of(const std::string& text) {
  ordered_json task = ordered_json::parse(text, nullptr, false);
  if (!task.is_object()) {
    throw InputError("identity", text, "must be a JSON object");
  }
  return task;
}

ordered_json to_json(const Checkpoint& checkpoint) {
  const SweepState& state = checkpoint.state;
  return {{"schema", schema},
          {"rows", state.rows},
          {"bytes", checkpoint.bytes},
          {"complete", checkpoint.complete},
          {"digest", state.digest},
          {"outcomes", state.outcomes},
          {"locked", state.locked_outcomes},
          {"feasible", state.feasible},
          {"bytes_digest", {state.bytes.words, state.bytes.rest, state.bytes.size}},
          {"task", task_of(checkpoint.task)}};
}

Checkpoint from_json(const ordered_json& document) {
  if (document.at("schema") != schema) {
    throw std::runtime_error("not a checkpoint");
  }
  Checkpoint checkpoint;
  checkpoint.task = document.at("task").dump();
  read_counts(document, checkpoint.state);
  read_integers(document.at("bytes"), checkpoint.bytes);
  document.at("complete").get_to(checkpoint.complete);
  read_integers(document.at("digest"), checkpoint.state.digest);
  const ordered_json& digest = document.at("bytes_digest");
  read_integers(digest.at(0), checkpoint.state.bytes.words);
  read_integers(digest.at(1), checkpoint.state.bytes.rest);
  read_integers(digest.at(2), checkpoint.state.bytes.size);
  if (std::min({checkpoint.state.rows, checkpoint.bytes, checkpoint.state.bytes.size}) < 0) {
    throw std::runtime_error("not a checkpoint");
  }
  return checkpoint;
}

std::string text(const ordered_json& task, const std::string& key) {
  return task.contains(key) ? task.at(key).dump() : "nothing";
}

}  // namespace

void require_task(const std::string& task) {
  static_cast<void>(task_of(task));
}

std::optional<Checkpoint> read_checkpoint(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) {
    return std::nullopt;
  }
  const std::string content = records::read_text_file("resume", path, largest);
  try {
    require_json_object(content, {.kind = "resume", .path = path});
    return from_json(ordered_json::parse(content));
  } catch (const std::exception&) {
    throw LeftoverError(
        fmt::format("resume {}: is not the checkpoint of a sweep: remove it to start again", path));
  }
}

int write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  const std::string next = path + ".new";
  // Our own file, even if somebody has put a link under its name.
  ::unlink(next.c_str());
  const Descriptor file(create_file(next));
  if (!file.is_open()) {
    return errno;
  }
  int error = write_all(file.number(), to_json(checkpoint).dump(2) + "\n");
  // In this order, or after a power cut the name may lead to nothing.
  if (error == 0 && (::fsync(file.number()) != 0 || std::rename(next.c_str(), path.c_str()) != 0)) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(next.c_str());
    return error;
  }
  return synchronize_name(path);
}

std::string difference(const std::string& old_task, const std::string& new_task) {
  const ordered_json was = task_of(old_task);
  const ordered_json is = task_of(new_task);
  for (const ordered_json* const task : {&was, &is}) {
    for (const auto& [key, value] : task->items()) {
      if (text(was, key) != text(is, key)) {
        return fmt::format("{} was {}, is {}", key, shortened(text(was, key), longest_word),
                           shortened(text(is, key), longest_word));
      }
    }
  }
  return {};
}

}  // namespace stillpoint::sweep
