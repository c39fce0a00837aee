// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/part_label.hpp>

#include "posix/part_file.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/sink.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

namespace {

[[noreturn]] void refuse_part(const PartLabel& label, std::string_view why) {
  throw records::FileError({.kind = "part", .path = label.path}, why);
}

}  // namespace

bool PartLabel::is_whole(std::int64_t rows) const {
  return 1 <= part.number && part.number <= part.count && part.count <= most_sweep_parts &&
         whole.entries >= 0 && rows == range_of(part, whole.entries).count;
}

PartLabel label_of(const SweepSpec& spec) {
  return {spec.output.value_or(""),
          spec.part.value_or(SweepPart()),
          spec.identity,
          {entries(spec).value_or(0), spec.listed ? spec.listed->digest : 0}};
}

std::string difference(const PartLabel& one, const PartLabel& other) {
  if (std::string tasks = difference(one.task, other.task); !tasks.empty()) {
    return tasks;
  }
  if (one.whole.entries != other.whole.entries) {
    return fmt::format("the number of entries was {} and is now {}", one.whole.entries,
                       other.whole.entries);
  }
  return one.whole.digest == other.whole.digest ? "" : "the list has changed";
}

bool is_that_part(const PartLabel& found, const PartLabel& wanted) {
  if (found.part.count != wanted.part.count || !difference(found, wanted).empty()) {
    return false;
  }
  if (found.part != wanted.part) {
    throw LeftoverError(fmt::format(
        "output {}: is part {} of this sweep: give each part its own file, for instance "
        "with {{part}} in its name",
        wanted.path, text(found.part)));
  }
  return true;
}

void PartOrder::add(PartLabel label) {
  if (!labels_.empty()) {
    const PartLabel& first = labels_.front();
    const std::string differs = difference(first, label);
    if (!differs.empty()) {
      refuse_part(label,
                  fmt::format("belongs to a different sweep from {}: {}", first.path, differs));
    }
    if (first.part.count != label.part.count) {
      refuse_part(label, fmt::format("is part {}, but {} is part {}", text(label.part), first.path,
                                     text(first.part)));
    }
    label.task.clear();  // that of the first is enough, and may be long
  }
  labels_.push_back(std::move(label));
}

std::vector<std::size_t> PartOrder::places() const {
  assert(!labels_.empty());
  std::vector<std::size_t> places(labels_.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const auto number = [this](std::size_t place) { return labels_[place].part.number; };
  std::ranges::stable_sort(places, {}, number);
  const auto twice = std::ranges::adjacent_find(places, {}, number);
  if (twice != places.end()) {
    const PartLabel& second = labels_[*(twice + 1)];
    refuse_part(second,
                fmt::format("is part {}, and so is {}", text(second.part), labels_[*twice].path));
  }
  const std::int64_t count = labels_.front().part.count;
  const std::int64_t missing = count - std::ssize(places);
  if (missing > 0) {
    std::int64_t first = 1;
    while (first <= std::ssize(places) &&
           number(places[static_cast<std::size_t>(first) - 1]) == first) {
      ++first;
    }
    throw InputError(
        "part", text(SweepPart{first, count}),
        missing == 1 ? "is missing" : fmt::format("is missing, the first of {}", missing));
  }
  return places;
}

}  // namespace stillpoint::sweep
