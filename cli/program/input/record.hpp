// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/record_list.hpp>

#include <optional>
#include <string>

namespace stillpoint::cli {

/// How the files of records are read, for a motion with this clock; the factor is 1.
[[nodiscard]] records::RecordOptions record_options(const Settings& settings,
                                                    const records::RecordClock& clock);

/// --record-peak or --record-spectrum. Throws InputError.
[[nodiscard]] records::RecordTarget record_target(const Settings& settings);

/// Scales records to targets.
class RecordScaling {
 public:
  /// `p` of the spectrum where --record-spectrum-period does not give it; empty: it must.
  RecordScaling(const Settings& settings, const records::RecordClock& clock,
                std::optional<double> p);

  /// What brings `record`, read from `path`, to the target: 1 without one. Throws InputError for a
  /// period that it does not resolve, FileError for a record that is 0 throughout.
  [[nodiscard]] double factor(const Record& record, const std::string& path,
                              const records::RecordTarget& target) const;

 private:
  records::RecordClock clock_;
  std::optional<double> p_;
};

}  // namespace stillpoint::cli
