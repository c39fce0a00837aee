// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include <stillpoint/report/reduction.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/sweep/merge.hpp>
#include <stillpoint/sweep/sink.hpp>

#include <nlohmann/json.hpp>

#include "posix/part_file.hpp"

#include <array>
#include <vector>

// What sweeps leave for one another: parts with rows, parts that are reduced, and checkpoints. Up
// to three files stand one behind the other, each behind a line "=====".

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;

constexpr std::string_view separator = "=====\n";

std::vector<std::string> files_of(std::string_view text) {
  std::vector<std::string> files;
  while (files.size() < 3 && text.starts_with(separator)) {
    text.remove_prefix(separator.size());
    const std::size_t end = std::min(text.find(separator), text.size());
    files.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return files;
}

/// Puts the place of its seal right, with which a part ends, the same number of bytes in it, and
/// its digest: any other is refused.
void seal(std::string& part) {
  constexpr std::size_t digits = 20;
  constexpr std::size_t tail = 2 * digits + 3;
  constexpr std::string_view bytes = "\"bytes\":";
  const std::size_t place = part.rfind("#stillpoint-part ");
  if (place == std::string::npos || part.size() < place + tail) {
    return;
  }
  if (const std::size_t key = part.find(bytes, place); key != std::string::npos) {
    const std::size_t begin = key + bytes.size();
    const std::size_t end = std::min(part.find(',', begin), part.size() - tail);
    part.replace(begin, end - begin, fmt::format("{}", place));
  }
  const std::size_t end = part.size() - tail;
  sweep::Digest digest;
  for (const char byte : part.substr(place, end - place)) {
    digest.add(std::uint64_t{static_cast<unsigned char>(byte)});
  }
  part.replace(end, tail, fmt::format(" {:020} {:020}\n", digest.value(), place));
}

void read_checkpoint(const std::string& path) {
  if (const auto checkpoint = sweep::read_checkpoint(path)) {
    sweep::Checkpoint other = *checkpoint;
    require(sweep::difference(*checkpoint, other).empty(), "a sweep is not itself");
    other.task = "{}";
    require_short("was " + sweep::difference(*checkpoint, other));
  }
}

void merge(const std::vector<std::string>& paths) {
  const sweep::Merged merged = sweep::merge("/dev/null", paths);
  if (!merged.whole.state.reduction.row.empty()) {
    // What is printed has no number that is not finite; that is an assertion.
    const report::ReductionReport report{merged.whole};
    static_cast<void>(text(document(report)));
    static_cast<void>(report::json_text(json(report)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array<MemoryFile, 3> places;
  std::vector<std::string> files = files_of(text_of(data, size));
  if (files.empty()) {
    return -1;  // not worth a place in the corpus
  }
  std::vector<std::string> paths;
  for (std::string& file : files) {
    seal(file);
    places.at(paths.size()).hold(file);
    paths.push_back(places.at(paths.size()).path());
  }
  accepted([&] { read_checkpoint(paths.front()); });
  accepted([&] { merge(paths); });
  return 0;
}
