// SPDX-License-Identifier: MIT

// Vectors of doubles for lanes, with short names.

// Read once for each instruction set, as Highway requires.
#if defined(STILLPOINT_LANE_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STILLPOINT_LANE_VECTORS_INL
#undef STILLPOINT_LANE_VECTORS_INL
#else
#define STILLPOINT_LANE_VECTORS_INL
#endif

#include "batch_entries.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Index = std::ptrdiff_t;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using Bits = hn::RebindToUnsigned<D>;
using Whole = hn::RebindToSigned<D>;

inline constexpr Index width = static_cast<Index>(hn::MaxLanes(D()));

HWY_INLINE V all(double value) {
  return hn::Set(D(), value);
}

HWY_INLINE V at(const double* data) {
  return hn::LoadU(D(), data);
}

HWY_INLINE V values(const EntryValues& entries, Index begin) {
  return entries.stride == 0 ? all(*entries.data) : at(entries.data + begin);
}

HWY_INLINE void put(V v, double* data) {
  hn::StoreU(v, D(), data);
}

/// Consecutive numbers.
template <Index count, class Number = double>
struct Column {
  HWY_ALIGN std::array<Number, static_cast<std::size_t>(count)> numbers{};

  HWY_INLINE Number& operator[](Index i) { return numbers[static_cast<std::size_t>(i)]; }
  HWY_INLINE const Number& operator[](Index i) const {
    return numbers[static_cast<std::size_t>(i)];
  }
};

template <Index count>
HWY_INLINE V at(const Column<count>& column, Index i) {
  return at(column.numbers.data() + i);
}

template <Index count>
HWY_INLINE void put(V v, Column<count>& column, Index i) {
  put(v, column.numbers.data() + i);
}

/// One for each lane.
HWY_INLINE unsigned bits(M mask) {
  std::array<std::uint8_t, 8> found{};
  hn::StoreMaskBits(D(), mask, found.data());
  return found[0];
}

HWY_INLINE M within(V v, double low, double high) {
  return hn::And(hn::Ge(v, all(low)), hn::Le(v, all(high)));
}

/// A permutation of a vector.
using Order = decltype(hn::IndicesFromVec(D(), hn::Zero(Bits())));

/// For each mask, the numbers of the lanes in it, then of the others: four bits each.
inline constexpr auto chosen_first = [] {
  std::array<std::uint64_t, 1U << width> table{};
  for (std::size_t mask = 0; mask < table.size(); ++mask) {
    unsigned place = 0;
    for (const std::size_t chosen : {1U, 0U}) {
      for (unsigned lane = 0; lane < width; ++lane) {
        if ((mask >> lane & 1U) == chosen) {
          table[mask] |= std::uint64_t{lane} << (4 * place++);
        }
      }
    }
  }
  return table;
}();

/// Brings the lanes of the mask to the front. Highway's Compress does the same, but copies its
/// table at each call when compiled by GCC 12.
HWY_INLINE Order to_front(M mask) {
  const Bits whole;
  const auto packed = hn::Set(whole, chosen_first[bits(mask)]);
  const auto shift = hn::ShiftLeft<2>(hn::Iota(whole, 0));
  return hn::IndicesFromVec(D(), hn::And(hn::Shr(packed, shift), hn::Set(whole, 15)));
}

HWY_INLINE V reordered(V v, Order order) {
  return hn::TableLookupLanes(v, order);
}

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
