// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/record_file.hpp>

#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace stillpoint::python {

/// Records that are given as arrays: (times, accelerations), or accelerations with a step of their
/// own. The commands read them in place of files.
class RecordArrays {
 public:
  /// A value of the option record: names for what are arrays, paths stay. Throws InputError.
  [[nodiscard]] nlohmann::json names_in(pybind11::handle value);

  /// What has been named; null if nothing was.
  [[nodiscard]] const std::shared_ptr<records::HeldFiles>& files() const { return files_; }

 private:
  [[nodiscard]] std::string hold(std::string text);

  std::shared_ptr<records::HeldFiles> files_;
};

}  // namespace stillpoint::python
