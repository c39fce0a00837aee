// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/merge.hpp>

#include "posix/part_file.hpp"
#include "seal.hpp"

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

[[noreturn]] void refuse_rows(const Seal& seal, std::string_view why) {
  throw records::FileError({.kind = "part", .path = seal.label.path}, why);
}

/// Of all parts, in order. Throws as merge does.
std::vector<Seal> read_seals(const std::vector<std::string>& paths) {
  if (paths.empty()) {
    throw InputError::missing("part", "name the files of all parts");
  }
  std::vector<Seal> seals;
  PartOrder order;
  seals.reserve(paths.size());
  for (const std::string& path : paths) {
    Seal& seal = seals.emplace_back(read_seal(path));
    order.add(seal.label);
    seal.label.task.clear();
    if (seal.npy_fields != seals.front().npy_fields) {
      refuse_rows(seal, "has numbers in a different byte order");
    }
  }
  std::vector<Seal> ordered;
  ordered.reserve(seals.size());
  for (const std::size_t place : order.places()) {
    ordered.push_back(std::move(seals[place]));
  }
  return ordered;
}

/// The header of the whole sweep: that of the first part, but with all rows.
std::string header_of(const Seal& first) {
  if (first.format == RowFormat::npy) {
    return npy_header(first.npy_fields, first.label.whole.entries);
  }
  std::ifstream file(first.label.path, std::ios::binary);
  std::string header(static_cast<std::size_t>(first.header), '\0');
  file.read(header.data(), first.header);
  return header;
}

class Joiner {
 public:
  Joiner(RowSink& sink, const MergeWatch& watch) : sink_(sink), watch_(watch) {}

  Merged join(const std::vector<Seal>& parts) {
    const std::string header = header_of(parts.front());
    try {
      write(header);
      merged_.stopped =
          !std::ranges::all_of(parts, [this](const Seal& part) { return append(part); });
    } catch (...) {
      sink_.leave();
      throw;
    }
    if (merged_.stopped) {
      sink_.leave();
    } else {
      SweepState whole;
      whole.rows = merged_.rows;
      sink_.finish(whole, header);
    }
    return merged_;
  }

 private:
  void write(std::string_view bytes) {
    sink_.write(bytes);
    merged_.bytes += static_cast<std::int64_t>(bytes.size());
  }

  /// Appends the rows of a part. False after a stop.
  bool append(const Seal& part) {
    std::ifstream file(part.label.path, std::ios::binary);
    ByteDigest digest;
    const ByteDigest& sealed = part.state.bytes;
    while (digest.size < sealed.size) {
      if (watch_.stop.stop_requested()) {
        return false;
      }
      // The header comes alone, and is not copied.
      const std::int64_t end = digest.size < part.header ? part.header : sealed.size;
      const bool rows = digest.size >= part.header;
      const auto most = std::min<std::int64_t>(end - digest.size, std::ssize(buffer_));
      file.read(buffer_.data(), most);
      const std::string_view read(buffer_.data(), static_cast<std::size_t>(file.gcount()));
      digest.add(read);
      if (std::ssize(read) != most) {
        refuse_rows(part, "cannot be read to its end");
      }
      if (rows) {
        write(read);
      }
      if (watch_.progress) {
        watch_.progress(merged_);
      }
    }
    if (digest != sealed) {
      refuse_rows(part, "has changed since it was written");
    }
    merged_.rows += part.state.rows;
    return true;
  }

  RowSink& sink_;
  const MergeWatch& watch_;
  Merged merged_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 20U);
};

}  // namespace

void require_apart(const NamedFile& written, const std::vector<std::string>& parts) {
  const auto& [field, path] = written;
  if (std::ranges::any_of(parts, [&to = path](const auto& part) { return same_file(part, to); })) {
    throw records::FileError({.kind = field, .path = path},
                             "would overwrite a part: give another file");
  }
}

Merged merge(const std::string& output, const std::vector<std::string>& parts,
             const MergeWatch& watch) {
  require_apart({"output", output}, parts);
  const std::vector<Seal> seals = read_seals(parts);
  const std::unique_ptr<RowSink> sink =
      open_whole(output, fmt::format(R"({{"merge_of": {}}})", parts.size()));
  return Joiner(*sink, watch).join(seals);
}

Merged merge(RowSink& sink, const std::vector<std::string>& parts, const MergeWatch& watch) {
  return Joiner(sink, watch).join(read_seals(parts));
}

}  // namespace stillpoint::sweep
