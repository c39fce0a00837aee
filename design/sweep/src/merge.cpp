// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/merge.hpp>

#include "posix/part_file.hpp"
#include "seal.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/npy.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string_view>

namespace stillpoint::sweep {

namespace {

struct PartOnDisk {
  std::string path;
  Seal seal;
};

[[noreturn]] void refuse(const PartOnDisk& part, std::string_view why) {
  throw records::FileError({.kind = "part", .path = part.path}, why);
}

/// `one` and `other` must be different parts of the same sweep.
void require_siblings(const PartOnDisk& one, const PartOnDisk& other) {
  const std::string differs = difference(one.seal, other.seal);
  if (!differs.empty()) {
    refuse(other, fmt::format("is of another sweep than {}: {}", one.path, differs));
  }
  if (one.seal.part.count != other.seal.part.count) {
    refuse(other, fmt::format("is part {}, but {} is part {}", text(other.seal.part), one.path,
                              text(one.seal.part)));
  }
}

/// `parts` are in order, and different.
void require_all(const std::vector<PartOnDisk>& parts) {
  const std::int64_t count = parts.front().seal.part.count;
  const std::int64_t missing = count - std::ssize(parts);
  if (missing == 0) {
    return;
  }
  std::int64_t first = 1;
  for (auto part = parts.begin(); part != parts.end() && part->seal.part.number == first; ++part) {
    ++first;
  }
  throw InputError(
      "part", text(SweepPart{first, count}),
      missing == 1 ? "is missing" : fmt::format("is missing, the first of {}", missing));
}

/// All parts, in order.
std::vector<PartOnDisk> read_parts(const std::vector<std::string>& paths) {
  std::vector<PartOnDisk> parts;
  parts.reserve(paths.size());
  for (const std::string& path : paths) {
    parts.push_back({path, read_seal(path)});
    require_siblings(parts.front(), parts.back());
    if (parts.size() > 1) {
      parts.back().seal.task.clear();  // that of the first is enough, and may be long
    }
  }
  std::ranges::stable_sort(parts, {}, [](const PartOnDisk& one) { return one.seal.part.number; });
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].seal.part == parts[i - 1].seal.part) {
      refuse(parts[i],
             fmt::format("is part {}, like {}", text(parts[i].seal.part), parts[i - 1].path));
    }
  }
  require_all(parts);
  return parts;
}

class Joiner {
 public:
  Joiner(RowSink& sink, const MergeWatch& watch) : sink_(sink), watch_(watch) {}

  void write(std::string_view bytes) {
    sink_.write(bytes);
    merged_.bytes += static_cast<std::int64_t>(bytes.size());
  }

  /// Appends the rows of a part. False after a stop.
  bool append(const PartOnDisk& part) {
    std::ifstream file(part.path, std::ios::binary);
    ByteDigest digest;
    const ByteDigest& sealed = part.seal.state.bytes;
    while (digest.size < sealed.size) {
      if (watch_.stop.stop_requested()) {
        return false;
      }
      // The header comes alone, and is not copied.
      const std::int64_t end = digest.size < part.seal.header ? part.seal.header : sealed.size;
      const bool rows = digest.size >= part.seal.header;
      const auto most = std::min<std::int64_t>(end - digest.size, std::ssize(buffer_));
      file.read(buffer_.data(), most);
      const std::string_view read(buffer_.data(), static_cast<std::size_t>(file.gcount()));
      digest.add(read);
      if (std::ssize(read) != most) {
        refuse(part, "cannot be read to its end");
      }
      if (rows) {
        write(read);
      }
      if (watch_.progress) {
        watch_.progress(merged_);
      }
    }
    if (digest != sealed) {
      refuse(part, "has changed since it was written");
    }
    merged_.rows += part.seal.state.rows;
    return true;
  }

  [[nodiscard]] const Merged& merged() const { return merged_; }

 private:
  RowSink& sink_;
  const MergeWatch& watch_;
  Merged merged_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 20U);
};

/// Of the whole sweep: that of the first part, but with all rows.
std::string header_of(const PartOnDisk& first) {
  const Seal& seal = first.seal;
  if (seal.format == RowFormat::npy) {
    return npy_header(seal.npy_fields, seal.whole.entries);
  }
  std::ifstream file(first.path, std::ios::binary);
  std::string header(static_cast<std::size_t>(seal.header), '\0');
  file.read(header.data(), seal.header);
  return header;
}

}  // namespace

Merged merge(const std::string& output, const std::vector<std::string>& paths,
             const MergeWatch& watch) {
  if (paths.empty()) {
    throw InputError::missing("part", "name the files of all parts");
  }
  for (const std::string& path : paths) {
    if (same_file(path, output)) {
      throw records::FileError({.kind = "output", .path = output},
                               "would overwrite a part: give another file");
    }
  }
  const std::vector<PartOnDisk> parts = read_parts(paths);
  const Seal& first = parts.front().seal;
  const std::string header = header_of(parts.front());
  nlohmann::ordered_json task{{"merge_of", first.part.count}};
  const std::unique_ptr<RowSink> sink = open_whole(output, task.dump());
  Joiner joiner(*sink, watch);
  Merged merged;
  try {
    joiner.write(header);
    merged.stopped = !std::ranges::all_of(
        parts, [&joiner](const PartOnDisk& part) { return joiner.append(part); });
  } catch (...) {
    sink->leave();
    throw;
  }
  merged.rows = joiner.merged().rows;
  merged.bytes = joiner.merged().bytes;
  if (merged.stopped) {
    sink->leave();
    return merged;
  }
  SweepState whole;
  whole.rows = merged.rows;
  sink->finish(whole, header);
  return merged;
}

}  // namespace stillpoint::sweep
