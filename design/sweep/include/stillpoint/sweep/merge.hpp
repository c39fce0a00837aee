// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/part.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

struct SweepSpec;

/// Which part of which sweep a file is.
struct PartLabel {
  std::string path;
  SweepPart part;
  std::string task;  ///< SweepSpec::identity
  ListExtent whole;  ///< entries of the whole sweep, and the digest of a list

  /// Whether there is such a part, and it has so many rows.
  [[nodiscard]] bool is_whole(std::int64_t rows) const;
};

/// Of the sweep, with its identity; the path is that of the output.
[[nodiscard]] PartLabel label_of(const SweepSpec& spec);

/// Empty if both are of the same sweep, else how they differ: "f was 0:1:10, is 0:1:20".
[[nodiscard]] std::string difference(const PartLabel& one, const PartLabel& other);

/// Puts parts in order.
class PartOrder {
 public:
  /// Of a "sweep" or whatever else is split, for messages.
  explicit PartOrder(std::string_view whole = "sweep") : whole_(whole) {}

  /// Throws records::FileError for a part of another whole than the first one.
  void add(PartLabel label);
  /// The places of the parts as they were added, from the first part to the last. Throws FileError
  /// for a part that is there twice, and InputError for one that is missing.
  [[nodiscard]] std::vector<std::size_t> places() const;

 private:
  std::string_view whole_;
  std::vector<PartLabel> labels_;
};

/// What has been joined.
struct Merged {
  std::int64_t rows{0};
  std::int64_t bytes{0};
  bool stopped{false};  ///< then nothing is left
};

struct MergeWatch {
  std::stop_token stop{};
  std::function<void(const Merged&)> progress{};  ///< called now and then
};

/// Throws FileError if the output is one of the parts.
void require_apart(const std::string& output, const std::vector<std::string>& parts);

/// Joins the parts of a sweep, in whatever order they are given, into the file that the sweep would
/// have written in one. Throws records::FileError for a part that is not whole, of another sweep,
/// given twice or changed since, and for an output that cannot be written; InputError for a part
/// that is missing. The file is then not written.
Merged merge(const std::string& output, const std::vector<std::string>& parts,
             const MergeWatch& watch = {});

}  // namespace stillpoint::sweep
