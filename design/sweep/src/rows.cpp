// SPDX-License-Identifier: MIT
#include "rows.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <algorithm>

namespace stillpoint::sweep {

std::string RowWriter::header(std::int64_t rows) const {
  return format_ == RowFormat::csv ? csv_header(columns_) : npy_header(columns_, rows);
}

const std::vector<std::string>& RowWriter::rows(const SweepBlock& block) {
  constexpr Eigen::Index piece = 4096;  // entries: some 300 kB, enough to be worth a thread
  pieces_.resize(static_cast<std::size_t>((block.size + piece - 1) / piece));
  for_each_entry(static_cast<Eigen::Index>(pieces_.size()), threads_, {}, [&](Eigen::Index i) {
    std::string& bytes = pieces_[static_cast<std::size_t>(i)];
    bytes.clear();
    const Eigen::Index begin = i * piece;
    const Eigen::Index end = std::min(begin + piece, block.size);
    if (format_ == RowFormat::csv) {
      append_csv(block, columns_, begin, end, bytes);
    } else {
      append_npy(block, columns_, begin, end, bytes);
    }
  });
  return pieces_;
}

}  // namespace stillpoint::sweep
