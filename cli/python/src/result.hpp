// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/answers/answer.hpp>

#include <pybind11/numpy.h>

#include <memory>
#include <string>
#include <utility>

namespace stillpoint::python {

/// What a command found. Its report is made when it is read.
class Result {
 public:
  explicit Result(std::unique_ptr<answers::Answer> answer) : answer_(std::move(answer)) {}
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  virtual ~Result() = default;

  /// The JSON as a dict, always the same one.
  [[nodiscard]] const pybind11::dict& report();
  [[nodiscard]] pybind11::object field(const std::string& name);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string one_line() const;
  [[nodiscard]] std::string html() const;

  [[nodiscard]] virtual const answers::Answer& answer() const { return *answer_; }

 private:
  std::unique_ptr<answers::Answer> answer_;
  pybind11::dict report_{pybind11::reinterpret_steal<pybind11::dict>(nullptr)};
};

void add_result(pybind11::module_& module);

}  // namespace stillpoint::python
