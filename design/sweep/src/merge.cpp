// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/merge.hpp>

#include "checkpoint.hpp"
#include "posix/part_file.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/npy.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

namespace {

[[noreturn]] void refuse_rows(const Checkpoint& part, std::string_view why) {
  throw records::FileError({.kind = "part", .path = part.label.path}, why);
}

/// What all parts say of themselves, in order. Throws as merge does.
std::vector<Checkpoint> read_seals(const std::vector<std::string>& paths) {
  std::vector<Checkpoint> parts;
  PartOrder order;
  parts.reserve(paths.size());
  for (const std::string& path : paths) {
    order.add(parts.emplace_back(read_seal(path)).label);
    parts.back().label.task.clear();  // may be long
  }
  std::vector<Checkpoint> ordered;
  ordered.reserve(parts.size());
  for (const std::size_t place : order.places()) {
    ordered.push_back(std::move(parts[place]));
  }
  return ordered;
}

class Joiner {
 public:
  Joiner(RowSink& sink, const MergeWatch& watch) : sink_(sink), watch_(watch) {}

  Merged join(const std::vector<Checkpoint>& parts) {
    try {
      merged_.stopped =
          !std::ranges::all_of(parts, [this](const Checkpoint& part) { return append(part); });
      if (!merged_.stopped) {
        sink_.finish(header_);
        return merged_;
      }
    } catch (...) {
      sink_.leave();
      throw;
    }
    sink_.leave();
    return merged_;
  }

 private:
  void write(std::string_view bytes) {
    sink_.write(bytes);
    merged_.bytes += static_cast<std::int64_t>(bytes.size());
  }

  /// That of the whole sweep comes first, alone.
  void write_header(const Checkpoint& part, const std::string& header) {
    const std::string whole = with_rows(header, part.label.whole.entries);
    if (header_.empty()) {
      write(header_ = whole);
    } else if (whole != header_) {
      refuse_rows(part, "has numbers in a different byte order");
    }
  }

  /// Appends the rows of a part. False after a stop.
  bool append(const Checkpoint& part) {
    std::ifstream file(part.label.path, std::ios::binary);
    const std::string header = read_header(file);
    write_header(part, header);
    std::int64_t left = part.state.bytes - std::ssize(header);
    while (left > 0) {
      if (watch_.stop.stop_requested()) {
        return false;
      }
      file.read(buffer_.data(), std::min<std::int64_t>(left, std::ssize(buffer_)));
      if (file.gcount() == 0) {
        refuse_rows(part, "cannot be read to its end");
      }
      write({buffer_.data(), static_cast<std::size_t>(file.gcount())});
      left -= file.gcount();
      if (watch_.progress) {
        watch_.progress(merged_);
      }
    }
    merged_.rows += part.state.rows;
    return true;
  }

  RowSink& sink_;
  const MergeWatch& watch_;
  std::string header_;
  Merged merged_;
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
  const std::vector<Checkpoint> seals = read_seals(parts);
  const std::unique_ptr<RowSink> sink =
      open_whole(output, fmt::format(R"({{"merge_of": {}}})", parts.size()));
  return Joiner(*sink, watch).join(seals);
}

Merged merge(RowSink& sink, const std::vector<std::string>& parts, const MergeWatch& watch) {
  return Joiner(sink, watch).join(read_seals(parts));
}

}  // namespace stillpoint::sweep
