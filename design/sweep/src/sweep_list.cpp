// SPDX-License-Identifier: MIT
#include "digest.hpp"
#include "progress.hpp"
#include "settings.hpp"
#include "sweep_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace stillpoint::cli {

namespace {

using Eigen::Index;

class ListSource : public SweepSource {
 public:
  ListSource(ListReader list, std::vector<SweepAxis> fixed)
      : list_(std::move(list)), fixed_(std::move(fixed)) {}

  void fill(SweepBlock& block, Index most) override {
    read(block, most);
    for (const SweepAxis& one : fixed_) {
      block[one.quantity].setConstant(block.size, one.axis[0]);
    }
  }

  void skip(std::int64_t entries, std::uint64_t digest) override {
    constexpr std::int64_t at_once = 4096;
    if (entries == 0) {
      return;
    }
    SweepBlock block;
    while (next_ < entries) {
      read(block, std::min(at_once, entries - next_));
      if (block.size == 0) {
        break;
      }
    }
    if (Progress::interrupted()) {
      return;
    }
    if (next_ != entries || digest_.value() != digest) {
      throw UsageError(fmt::format(
          "list {}: its first {} entries are not those that the interrupted sweep was given",
          list_.source(), entries));
    }
  }

  [[nodiscard]] std::optional<std::int64_t> total() const override { return std::nullopt; }

  [[nodiscard]] std::string place(const SweepBlock& block, Index i) const override {
    return fmt::format("list {}: line {}", list_.source(),
                       block.lines[static_cast<std::size_t>(i)]);
  }

 private:
  void read(SweepBlock& block, Index most) {
    if (wrong_) {
      throw UsageError(*wrong_);
    }
    block.first = next_;
    block.lines.clear();
    block.digests.clear();
    for (const Quantity column : list_.columns()) {
      block[column].resize(most);
    }
    Index size = 0;
    for (; size < most && has_next(size); ++size) {
      block.lines.push_back(list_.line());
      for (std::size_t i = 0; i < values_.size(); ++i) {
        block[list_.columns()[i]][size] = values_[i];
        digest_.add(values_[i]);
      }
      block.digests.push_back(digest_.value());
    }
    for (const Quantity column : list_.columns()) {
      block[column].conservativeResize(size);
    }
    block.size = size;
    next_ += size;
  }

  /// Reads the next entry. What is wrong with it is kept until those before it, `size` in this
  /// block, have been given.
  bool has_next(Index size) {
    try {
      return list_.next(values_);
    } catch (const UsageError& error) {
      if (size == 0) {
        throw;
      }
      wrong_ = error.what();
      return false;
    }
  }

  ListReader list_;
  std::optional<std::string> wrong_;
  std::vector<SweepAxis> fixed_;
  std::vector<double> values_;
  Digest digest_;
  std::int64_t next_{0};
};

}  // namespace

std::unique_ptr<SweepSource> list_source(ListReader list, std::vector<SweepAxis> fixed) {
  return std::make_unique<ListSource>(std::move(list), std::move(fixed));
}

}  // namespace stillpoint::cli
