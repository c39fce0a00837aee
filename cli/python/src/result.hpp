// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include <stillpoint/answers/answer.hpp>

namespace stillpoint::python {

/// What a command found. Its report is made when it is read.
class Result {
 public:
  /// `rows` are the array of the result, or None.
  explicit Result(std::shared_ptr<const answers::Answer> answer,
                  pybind11::object rows = pybind11::none());
  /// One that was pickled, maybe in another process.
  explicit Result(const pybind11::tuple& state);
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  virtual ~Result() = default;

  /// The JSON as a dict, always the same one.
  [[nodiscard]] const pybind11::dict& report();
  [[nodiscard]] pybind11::object field(const std::string& name);
  [[nodiscard]] const pybind11::object& rows() const { return rows_; }
  [[nodiscard]] pybind11::str text() const;
  [[nodiscard]] pybind11::str one_line() const;
  [[nodiscard]] pybind11::str html() const;

  [[nodiscard]] const answers::Answer& answer() const { return *answer_; }
  /// All that can be read of it.
  [[nodiscard]] pybind11::tuple state();

 private:
  struct Told {
    pybind11::str text;
    pybind11::str one_line;
    pybind11::str html;
  };

  std::shared_ptr<const answers::Answer> answer_;  ///< null if it was pickled
  std::optional<Told> told_;                       ///< if it was pickled
  pybind11::object rows_;
  pybind11::dict report_{pybind11::reinterpret_steal<pybind11::dict>(nullptr)};
};

/// A class of results, which can be pickled and copied.
template <class Kind, class... Base>
pybind11::class_<Kind, Base...> result_class(pybind11::module_& module, const char* name,
                                             const char* about) {
  return pybind11::class_<Kind, Base...>(module, name, about)
      .def(pybind11::pickle(
          [](Kind& result) { return result.state(); },
          [](const pybind11::tuple& state) { return std::make_unique<Kind>(state); }));
}

}  // namespace stillpoint::python
