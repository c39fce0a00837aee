// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include <stillpoint/records/record_file.hpp>
#include <stillpoint/sweep/list.hpp>

namespace stillpoint::python {

/// What is given as arrays, and read in place of files: records, (times, accelerations), or
/// accelerations with a step of their own; and the columns of a list.
class HeldArrays {
 public:
  /// A value of the option record: names for what are arrays, paths stay. Throws InputError.
  [[nodiscard]] nlohmann::json names_in(pybind11::handle value);

  /// A value of the option list: a name for what has named columns, a path stays. Throws
  /// InputError.
  [[nodiscard]] nlohmann::json name_of_list(pybind11::handle value);

  /// What has been named; null if nothing was.
  [[nodiscard]] const std::shared_ptr<records::HeldFiles>& files() const { return files_; }
  [[nodiscard]] const std::shared_ptr<const sweep::ListColumns>& list() const { return list_; }

 private:
  [[nodiscard]] std::string hold(std::string text);

  std::shared_ptr<records::HeldFiles> files_;
  std::shared_ptr<const sweep::ListColumns> list_;
};

}  // namespace stillpoint::python
