// SPDX-License-Identifier: MIT
#include "source.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/state.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;

class ListSource : public SweepSource {
 public:
  ListSource(const SweepSpec& spec, std::stop_token stop)
      : list_(spec.list),
        fixed_(spec.axes),
        stop_(std::move(stop)),
        front_(given(spec, Quantity::trade_off)),
        of_each_(dampers_of_each(spec)) {
    std::erase_if(fixed_,
                  [](const SweepAxis& axis) { return axis.quantity == Quantity::trade_off; });
  }

  void fill(SweepBlock& block, Index most) override {
    const std::int64_t first = next_;
    read(block, most);
    if (front_) {
      block[Quantity::trade_off] = Eigen::ArrayXd::NullaryExpr(
          block.size, [&](Index i) { return static_cast<double>((first + i) % of_each_ + 1); });
    }
    for (const SweepAxis& one : fixed_) {
      block[one.quantity].setConstant(block.size, one.axis[0]);
      if (one.axis.has_ranges()) {
        block[*other_end(one.quantity)].setConstant(block.size, one.axis.other_ends()[0]);
      }
    }
  }

  void skip(std::int64_t entries, std::optional<std::uint64_t> digest) override {
    constexpr std::int64_t at_once = 4096;
    SweepBlock block;
    while (next_ < entries) {
      read(block, std::min(at_once, entries - next_));
      if (block.size == 0) {
        break;
      }
    }
    if (digest && !stop_.stop_requested() && (next_ != entries || digest_.value() != digest)) {
      throw records::FileError(
          {.kind = "list", .path = list_->source()},
          fmt::format("its first {} entries differ from those that the interrupted sweep read",
                      entries));
    }
  }

  [[noreturn]] void refuse(const SweepBlock& block, Index i,
                           const std::string& reason) const override {
    list_->refuse(block.lines[static_cast<std::size_t>(i)], reason);
  }

 private:
  void read(SweepBlock& block, Index most) {
    if (wrong_) {
      std::rethrow_exception(wrong_);
    }
    block.first = next_;
    block.lines.clear();
    block.digests.clear();
    for (const Quantity column : list_->columns()) {
      block[column].resize(most);
    }
    Index size = 0;
    for (; size < most && has_next(size); ++size) {
      block.lines.push_back(list_->line());
      for (std::size_t i = 0; i < values_.size(); ++i) {
        block[list_->columns()[i]][size] = values_[i];
      }
      block.digests.push_back(digest_.value());
    }
    for (const Quantity column : list_->columns()) {
      block[column].conservativeResize(size);
    }
    block.size = size;
    next_ += size;
  }

  /// Reads the next entry, or returns the last one again for the next damper of its front. An error
  /// is kept until the `size` entries before it in this block have been returned.
  bool has_next(Index size) {
    if ((next_ + size) % of_each_ != 0) {
      return true;
    }
    try {
      if (!list_->next(values_, stop_)) {
        return false;
      }
      std::ranges::for_each(values_, [this](double value) { digest_.add(value); });
      return true;
    } catch (const records::FileError&) {
      if (size == 0) {
        throw;
      }
      wrong_ = std::current_exception();
      return false;
    }
  }

  std::shared_ptr<List> list_;
  std::vector<SweepAxis> fixed_;
  std::stop_token stop_;
  bool front_;
  std::int64_t of_each_;  ///< rows of an entry, one after the other
  std::exception_ptr wrong_;
  std::vector<double> values_;
  Digest digest_;
  std::int64_t next_{0};
};

}  // namespace

std::unique_ptr<SweepSource> list_source(const SweepSpec& spec, std::stop_token stop) {
  return std::make_unique<ListSource>(spec, std::move(stop));
}

}  // namespace stillpoint::sweep
