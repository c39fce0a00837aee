// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"

#include <stillpoint/records/record_file.hpp>

#include <cstddef>

namespace stillpoint::records {

/// A format of record files: one source file defines it, one row in record_file.cpp lists it.
struct RecordFormat {
  bool (*recognises)(RecordReader reader);  ///< may read ahead in its copy
  RecordFile (*read)(RecordReader& reader);
};

/// Of the description of a record; more is cut off.
inline constexpr std::size_t longest_description = 200;

extern const RecordFormat at2_format;
extern const RecordFormat columns_format;

}  // namespace stillpoint::records
