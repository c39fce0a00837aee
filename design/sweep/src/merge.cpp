// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/merge.hpp>

#include "posix/part_file.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/npy.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

namespace {

[[noreturn]] void refuse_part(const Checkpoint& part, std::string_view why) {
  throw records::FileError({.kind = "part", .path = part.path}, why);
}

/// Throws FileError unless the part belongs to the same sweep as the first.
void require_same_sweep(const Checkpoint& first, const Checkpoint& part) {
  if (const std::string differs = difference(first, part); !differs.empty()) {
    refuse_part(part, fmt::format("belongs to a different sweep from {}: {}", first.path, differs));
  }
}

/// Throws FileError for a part that appears twice, and InputError for one that is missing.
void require_each_once(const std::vector<Checkpoint>& ordered) {
  std::int64_t next = 1;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const SweepPart& part = ordered[i].part;
    if (i > 0 && part == ordered[i - 1].part) {
      refuse_part(ordered[i],
                  fmt::format("is part {}, and so is {}", text(part), ordered[i - 1].path));
    }
    next += part.number == next ? 1 : 0;
  }
  const std::int64_t count = ordered.front().part.count;
  if (next <= count) {
    const std::int64_t missing = count - std::ssize(ordered);
    throw InputError(
        "part", text(SweepPart{next, count}),
        missing == 1 ? "is missing" : fmt::format("is missing, the first of {}", missing));
  }
}

/// What all parts say of themselves.
struct Parts {
  std::vector<Checkpoint> ordered;  ///< what they reduce is in the whole alone
  Checkpoint whole;                 ///< but for its bytes
};

/// Throws as merge does.
Parts read_parts(const std::vector<std::string>& paths) {
  if (paths.empty()) {
    throw InputError::missing("part", "name the files of all parts");
  }
  Parts parts{{}, read_seal(paths.front())};
  parts.ordered.reserve(paths.size());
  Checkpoint& whole = parts.whole;
  for (const std::string& path : paths) {
    cancellation_point();
    Checkpoint& part = parts.ordered.emplace_back(read_seal(path));
    require_same_sweep(whole, part);
    part.task.clear();  // may be long
    try {
      if (parts.ordered.size() > 1) {
        whole.state.add(part.state);
      }
    } catch (const std::exception&) {
      refuse_part(part, fmt::format("cannot be added to {}", paths.front()));
    }
    part.state.reduction = {};
  }
  std::ranges::stable_sort(parts.ordered, {},
                           [](const Checkpoint& one) { return one.part.number; });
  require_each_once(parts.ordered);
  whole.part = {};
  whole.state.digest = whole.whole.digest;
  return parts;
}

/// Writes the rows of all parts one after the other, behind the header of the whole. After a stop
/// they are not complete.
void join(const std::vector<Checkpoint>& parts, RowSink& sink, Merged& merged,
          const MergeWatch& watch) {
  std::vector<char> buffer(std::size_t{1} << 20U);
  std::string header;
  const auto write = [&](std::string_view bytes) {
    sink.write(bytes);
    merged.bytes += std::ssize(bytes);
  };
  for (const Checkpoint& part : parts) {
    std::ifstream file(part.path, std::ios::binary);
    const auto read = [&](std::int64_t most) {
      file.read(buffer.data(), std::min(most, std::ssize(buffer)));
      return std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount()));
    };
    const std::string whole = with_rows(std::string(read(part.state.header)), part.whole.entries);
    if (header.empty()) {
      write(header = whole);
    } else if (whole != header) {
      refuse_part(part, "has numbers in a different byte order");
    }
    for (std::int64_t left = part.state.bytes - part.state.header; left > 0;
         left -= file.gcount()) {
      merged.stopped = watch.stop.stop_requested();
      if (merged.stopped) {
        return;
      }
      const std::string_view rows = read(left);
      if (rows.empty()) {
        refuse_part(part, "cannot be read to its end");
      }
      write(rows);
      if (watch.progress) {
        watch.progress(merged);
      }
    }
  }
  sink.finish(header);
}

}  // namespace

void require_apart(const NamedFile& written, const std::vector<std::string>& parts) {
  std::vector<NamedFile> read;
  read.reserve(parts.size());
  for (const std::string& part : parts) {
    read.push_back({"part", part});
  }
  require_apart(read, {written});
}

Merged merge(const std::string& output, const std::vector<std::string>& parts,
             const MergeWatch& watch) {
  require_apart({"output", output}, parts);
  auto [ordered, whole] = read_parts(parts);
  Merged merged{std::move(whole)};
  if (merged.whole.state.reduction.row.empty()) {
    const std::unique_ptr<RowSink> sink =
        open_whole(output, fmt::format(R"({{"merge_of": {}}})", parts.size()));
    try {
      join(ordered, *sink, merged, watch);
    } catch (...) {
      sink->leave();
      throw;
    }
    if (merged.stopped) {
      sink->leave();
    }
  }
  return merged;
}

}  // namespace stillpoint::sweep
