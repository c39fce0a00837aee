// SPDX-License-Identifier: MIT
#include "source.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <exception>
#include <functional>
#include <stdexcept>
#include <utility>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;

/// The values of an axis up to this long are computed once and kept, in half a megabyte.
constexpr std::int64_t longest_kept = 65'536;

/// One axis and how its values repeat: entry n has value n / stride % size.
class Turning {
 public:
  Turning(SweepAxis swept, std::int64_t stride)
      : quantity_(swept.quantity), axis_(std::move(swept.axis)), stride_(stride) {
    if (axis_.size() <= longest_kept) {
      kept_.reserve(static_cast<std::size_t>(axis_.size()));
      for (std::int64_t i = 0; i < axis_.size(); ++i) {
        kept_.push_back(axis_[i]);
      }
    }
  }

  [[nodiscard]] Quantity quantity() const { return quantity_; }
  [[nodiscard]] bool varies() const { return axis_.size() > 1; }

  /// The values of the entries from `first` on.
  void fill(Eigen::ArrayXd& values, std::int64_t first) const {
    std::int64_t i = first / stride_ % axis_.size();
    std::int64_t left = stride_ - first % stride_;
    for (Index begin = 0; begin < values.size();) {
      const Index count = std::min<std::int64_t>(left, values.size() - begin);
      values.segment(begin, count) = at(i);
      begin += count;
      i = i + 1 == axis_.size() ? 0 : i + 1;
      left = stride_;
    }
  }

 private:
  [[nodiscard]] double at(std::int64_t i) const {
    return kept_.empty() ? axis_[i] : kept_[static_cast<std::size_t>(i)];
  }

  Quantity quantity_;
  Axis axis_;
  std::vector<double> kept_;
  std::int64_t stride_;
};

class GridSource : public SweepSource {
 public:
  GridSource(std::vector<SweepAxis> axes, const std::optional<SweepUnits>& units) : units_(units) {
    std::ranges::sort(axes, std::greater(), &SweepAxis::quantity);
    for (SweepAxis& swept : axes) {
      const std::int64_t size = swept.axis.size();
      if (swept.axis.has_ranges()) {
        axes_.emplace_back(SweepAxis{*other_end(swept.quantity), swept.axis.other_ends()}, total_);
      }
      axes_.emplace_back(std::move(swept), total_);
      total_ *= size;
    }
    std::ranges::reverse(axes_);
  }

  void fill(SweepBlock& block, Index most) override {
    block.size = std::min<std::int64_t>(most, total_ - next_);
    block.first = next_;
    for (const Turning& axis : axes_) {
      Eigen::ArrayXd& values = block[axis.quantity()];
      values.resize(block.size);
      axis.fill(values, next_);
    }
    next_ += block.size;
  }

  void skip(std::int64_t entries, std::optional<std::uint64_t> /*digest*/) override {
    assert(next_ == 0 && entries <= total_);
    next_ = entries;
  }

  /// "entry 7 (f = 0.1, delta = 0.2): ..."
  [[noreturn]] void refuse(const SweepBlock& block, Index i,
                           const std::string& reason) const override {
    std::string values;
    for (const Turning& axis : axes_) {
      if (axis.varies()) {
        values += fmt::format("{}{} = {}", values.empty() ? "" : ", ",
                              name(axis.quantity(), units_), block[axis.quantity()][i]);
      }
    }
    const std::int64_t entry = block.first + i;
    throw EntryError(
        entry, std::make_exception_ptr(std::runtime_error(
                   values.empty() ? reason
                                  : fmt::format("entry {} ({}): {}", entry + 1, values, reason))));
  }

 private:
  std::vector<Turning> axes_;
  std::optional<SweepUnits> units_;
  std::int64_t total_{1};
  std::int64_t next_{0};
};

}  // namespace

std::unique_ptr<SweepSource> grid_source(const SweepSpec& spec) {
  return std::make_unique<GridSource>(spec.axes, spec.units);
}

}  // namespace stillpoint::sweep
