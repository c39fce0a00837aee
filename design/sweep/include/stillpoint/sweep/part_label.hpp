// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/part.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace stillpoint::sweep {

struct SweepSpec;

/// Which part of which sweep a file is.
struct PartLabel {
  std::string path{};
  SweepPart part{};
  std::string task{};  ///< SweepSpec::identity
  ListExtent whole{};  ///< entries of the whole sweep, and the digest of a list; 0 if not counted

  /// How many the part has if it is complete; empty if there is no such part.
  [[nodiscard]] std::optional<std::int64_t> rows() const;
};

/// SweepSpec::identity of a spec that is otherwise complete: everything that a result depends on,
/// as a JSON object. `inputs` is a JSON object with everything that was given and decides the
/// numbers; `version` is that of the program that computes them.
[[nodiscard]] std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                                      std::string_view version);

/// The label of a sweep, with its identity; the path is that of the output. Throws InputError
/// unless the identity is a JSON object.
[[nodiscard]] PartLabel label_of(const SweepSpec& spec);

/// Empty if both belong to the same sweep in as many parts, else how they differ: "f was 0:1:10, is
/// 0:1:20".
[[nodiscard]] std::string difference(const PartLabel& one, const PartLabel& other);

/// Whether an existing file, `found`, holds the part `wanted`. Throws FileError for another part of
/// the same sweep.
[[nodiscard]] bool is_that_part(const PartLabel& found, const PartLabel& wanted);

/// What `read` makes of the file of the part `wanted`, with a `label`; empty if the file does not
/// exist or holds anything else. Throws as is_that_part does.
template <class Read>
[[nodiscard]] auto find_part(const PartLabel& wanted, const Read& read) {
  std::optional<std::invoke_result_t<const Read&, const std::string&>> found;
  try {
    found = std::invoke(read, wanted.path);
  } catch (const records::FileError&) {
    return found;
  }
  if (!is_that_part(found->label, wanted)) {
    found.reset();
  }
  return found;
}

/// Puts parts in order.
class PartOrder {
 public:
  /// Throws records::FileError for a part that belongs to a different sweep from the first one.
  void add(PartLabel label);
  /// The indices of the parts as they were added, from the first part to the last. Throws FileError
  /// for a part that appears twice, and InputError for one that is missing.
  [[nodiscard]] std::vector<std::size_t> places() const;

 private:
  std::vector<PartLabel> labels_;
};

}  // namespace stillpoint::sweep
