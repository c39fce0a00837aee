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

constexpr std::int64_t longest_header = std::int64_t{1} << 20U;

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

/// Writes the rows of all parts one after the other.
class Joiner {
 public:
  Joiner(RowSink& sink, Merged& merged, const MergeWatch& watch)
      : sink_(sink), merged_(merged), watch_(watch) {}

  void join(const std::vector<Checkpoint>& parts) {
    try {
      merged_.stopped =
          !std::ranges::all_of(parts, [this](const Checkpoint& part) { return append(part); });
      if (!merged_.stopped) {
        return sink_.finish(header_);
      }
    } catch (...) {
      sink_.leave();
      throw;
    }
    sink_.leave();
  }

 private:
  void write(std::string_view bytes) {
    sink_.write(bytes);
    merged_.bytes += static_cast<std::int64_t>(bytes.size());
  }

  /// That of the whole sweep comes first, alone.
  void write_header(const Checkpoint& part, const std::string& header) {
    const std::string whole = with_rows(header, part.whole.entries);
    if (header_.empty()) {
      write(header_ = whole);
    } else if (whole != header_) {
      refuse_part(part, "has numbers in a different byte order");
    }
  }

  /// Appends the rows of a part. False after a stop.
  bool append(const Checkpoint& part) {
    std::ifstream file(part.path, std::ios::binary);
    std::string header(static_cast<std::size_t>(std::min(part.state.header, longest_header)), '\0');
    file.read(header.data(), std::ssize(header));
    write_header(part, header);
    for (std::int64_t left = part.state.bytes - std::ssize(header); left > 0;
         left -= file.gcount()) {
      if (watch_.stop.stop_requested()) {
        return false;
      }
      file.read(buffer_.data(), std::min<std::int64_t>(left, std::ssize(buffer_)));
      if (file.gcount() == 0) {
        refuse_part(part, "cannot be read to its end");
      }
      write({buffer_.data(), static_cast<std::size_t>(file.gcount())});
      if (watch_.progress) {
        watch_.progress(merged_);
      }
    }
    return true;
  }

  RowSink& sink_;
  Merged& merged_;
  const MergeWatch& watch_;
  std::string header_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 20U);
};

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
    Joiner(*sink, merged, watch).join(ordered);
  }
  return merged;
}

}  // namespace stillpoint::sweep
