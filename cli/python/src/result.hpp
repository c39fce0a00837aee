// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>

#include <pybind11/numpy.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>

namespace stillpoint::python {

/// What a command found. Its report is made when someone looks.
class Result {
 public:
  Result() = default;
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  Result(Result&&) = delete;
  Result& operator=(Result&&) = delete;
  virtual ~Result() = default;

  [[nodiscard]] virtual nlohmann::ordered_json json() const = 0;
  [[nodiscard]] virtual report::Document document() const = 0;
  [[nodiscard]] virtual figures::HtmlPage page() const = 0;

  /// The JSON as a dict, always the same one.
  [[nodiscard]] const pybind11::dict& report();
  [[nodiscard]] pybind11::object field(const std::string& name);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string one_line() const;
  [[nodiscard]] std::string html() const;

 private:
  pybind11::dict report_{pybind11::reinterpret_steal<pybind11::dict>(nullptr)};
};

/// Of a report that has json(), document() and page().
template <class Report>
class ResultOf : public Result {
 public:
  explicit ResultOf(Report report) : report_(std::move(report)) {}

  [[nodiscard]] nlohmann::ordered_json json() const override { return report::json(report_); }
  [[nodiscard]] report::Document document() const override { return report::document(report_); }
  [[nodiscard]] figures::HtmlPage page() const override { return report::page(report_); }

 protected:
  [[nodiscard]] const Report& made() const { return report_; }

 private:
  Report report_;
};

void add_result(pybind11::module_& module);

}  // namespace stillpoint::python
